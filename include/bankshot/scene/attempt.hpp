// SPDX-License-Identifier: MIT
//
// A player's attempt at a shot: the intended shot and the observations of it.
#pragma once

#include "bankshot/scene/recording.hpp"

namespace bankshot {

struct Attempt {
  Recording seen{};                ///< the observations; a given launch is the intended one
  std::optional<Puzzle> puzzle{};  ///< the intended puzzle; without a launch, its most successful shot was intended
  std::optional<bool> made{};
};

/// Reads an attempt. Throws InvalidInput as `read_recording` does, and if the intention or the outcome is missing.
Attempt read_attempt(std::string_view text);

}  // namespace bankshot
