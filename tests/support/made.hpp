// SPDX-License-Identifier: MIT
//
// Facts about a puzzle that follow from the shot that it was made from.
#pragma once

#include <vector>

#include "bankshot/plan/shot.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// Returns true when the shot meets other cushions if its aim is turned by `beside` rad either way. Such a shot runs
/// through a corner or exactly along a cushion, and rounding decides.
bool through_corner(const Made& made, double beside);
/// Returns true when κ (simulate/simulator.hpp, property 6) up to the event after the target is 1e6 or more, or when
/// the shot meets other cushions 1e-9 rad beside its aim.
bool is_hard(const Made& made);
/// Returns true when the shot itself is exact: it meets the point, or the pocket's exact line.
bool is_exact(const Made& made);
/// Returns true when the puzzle asks for isolated launches, not for curves of them, and the shot is one of them.
bool nothing_free(const Made& made);
/// Returns true when `shots` contain the launch, to 1e-5 rad and 1e-5 of its speed.
bool is_among(const Launch& launch, const std::vector<Shot>& shots);

}  // namespace bankshot::test
