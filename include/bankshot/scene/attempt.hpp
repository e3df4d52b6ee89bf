// SPDX-License-Identifier: MIT
//
// A player's attempt at a shot: what was meant, and what was seen of it.
#pragma once

#include "bankshot/scene/recording.hpp"

namespace bankshot {

struct Attempt {
  Recording seen{};                ///< its launch, where one is given, is the one that was meant
  std::optional<Puzzle> puzzle{};  ///< that was meant; with no launch given its likeliest shot
  std::optional<bool> made{};
};

/// Throws InvalidInput as `read_recording` does, and where it does not say what was meant or what happened.
Attempt read_attempt(std::string_view text);

}  // namespace bankshot
