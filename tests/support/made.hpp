// SPDX-License-Identifier: MIT
//
// What is known of the shot that a puzzle was made from, and so of the puzzle.
#pragma once

#include <vector>

#include "bankshot/plan/shot.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// The shot meets other cushions so many rad beside its aim: it runs through a corner or exactly along a cushion, and
/// rounding decides.
bool through_corner(const Made& made, double beside);
/// κ (simulate/simulator.hpp, property 6) up to the event after its target is 1e6 or more, or 1e-9 rad beside its aim
/// it meets other cushions.
bool is_hard(const Made& made);
/// Some root is on the point or on the pocket's exact line: that of the shot.
bool is_exact(const Made& made);
/// Only single launches are asked for, not families of them, and the shot is one.
bool nothing_free(const Made& made);
/// A launch as one of a list, to 1e-5 rad and 1e-5 of its speed.
bool is_among(const Launch& launch, const std::vector<Shot>& shots);

}  // namespace bankshot::test
