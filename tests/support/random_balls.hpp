// SPDX-License-Identifier: MIT
//
// Random shots with other balls on the table. The draws are seeded.
#pragma once

#include <string>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

enum class BallFamily {
  scattered,  ///< 1 to 15 balls anywhere
  sizes,      ///< different radii, masses, restitutions and frictions
  frozen,     ///< many balls touch the cue ball, each other or a cushion
  slow,       ///< 1e-5 to 1e-2 m/s among touching balls
  elastic,    ///< restitution 1, no friction between balls
  drag,       ///< rolling friction grows with the speed
  rolling,    ///< `rolling` physics
  ideal       ///< `ideal` physics for 5 s
};
inline constexpr BallFamily ball_families[] = {BallFamily::scattered, BallFamily::sizes,   BallFamily::frozen,
                                               BallFamily::slow,      BallFamily::elastic, BallFamily::drag,
                                               BallFamily::rolling,   BallFamily::ideal};
std::string name(BallFamily family);

/// Draws a valid shot.
ShotRequest random_balls(Random& random, BallFamily family);

/// Draws a hard break on pool-9ft: fifteen racked balls, each `gap` metres from the next, and a cue ball anywhere
/// behind the line.
ShotRequest break_shot(Random& random, double gap);

}  // namespace bankshot::test
