// SPDX-License-Identifier: MIT
//
// Checks a shot against its puzzle by a plain recorded simulation, which shares no code with the planners' own
// verification.
#pragma once

#include <string>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

struct Checked {
  std::string problem;     ///< empty when the shot does what it claims
  double speed_error = 0;  ///< |arrival speed − asked| / max(1, asked)
};

Checked check_shot(const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot::test
