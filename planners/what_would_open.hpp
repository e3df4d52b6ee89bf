// SPDX-License-Identifier: MIT
//
// What would make a shot possible where there is none.
#pragma once

#include <functional>
#include <string>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// Answers a puzzle, with no margin and no hints.
using Solve = std::function<Answer(const Puzzle&)>;

/// Solves the puzzle with a bound loosened, cheapest first, and says which loosening opens it: more
/// speed, any aim, other counts of cushions, side spin. Empty when none of these does.
std::string what_would_open(const Puzzle& puzzle, const Solve& solve);

}  // namespace bankshot::planning
