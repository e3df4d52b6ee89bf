// SPDX-License-Identifier: MIT
//
// Relaxations: which loosened bound makes a shot possible if there is none.
#pragma once

#include <functional>
#include <string>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// Answers a puzzle, with no margin and no hints.
using Solve = std::function<Answer(const Puzzle&)>;
/// Returns whether the launch of a shot is a shot of the puzzle as it was asked.
using IsAsked = std::function<bool(const Shot&)>;

/// Solves the puzzle with one bound loosened at a time, cheapest first, and says which relaxation opens it: no other
/// balls, more or less speed, any aim, other counts of cushions, side spin. Empty if none does. Also empty if such a
/// search finds a shot as asked; then it ends there.
std::string what_would_open(const Puzzle& puzzle, const Solve& solve, const IsAsked& is_asked);

}  // namespace bankshot::planning
