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
/// True where the launch of a shot is one of the puzzle as it was asked.
using IsAsked = std::function<bool(const Shot&)>;

/// Solves the puzzle with a bound loosened, cheapest first, and says which loosening opens it: no other balls, more or
/// less speed, any aim, other counts of cushions, side spin. Empty when none of these does, and when such a search
/// comes upon a shot that is one as asked: then it ends there.
std::string what_would_open(const Puzzle& puzzle, const Solve& solve, const IsAsked& is_asked);

}  // namespace bankshot::planning
