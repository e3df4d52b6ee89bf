// SPDX-License-Identifier: MIT
//
// Random shots with other balls on the table. Seeded.
#pragma once

#include <string>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

/// scattered: 1 to 15 balls anywhere. sizes: of different radii and masses, e and μ. frozen: many touch the struck
/// ball, each other or a cushion. slow: 1e-5 to 1e-2 m/s among touching balls. elastic: restitution 1, no friction
/// between balls. drag: rolling friction grows with the speed. rolling, ideal: those physics (ideal for 5 s).
enum class BallFamily { scattered, sizes, frozen, slow, elastic, drag, rolling, ideal };
inline constexpr BallFamily ball_families[] = {BallFamily::scattered, BallFamily::sizes,   BallFamily::frozen,
                                               BallFamily::slow,      BallFamily::elastic, BallFamily::drag,
                                               BallFamily::rolling,   BallFamily::ideal};
std::string name(BallFamily family);

/// Always valid.
ShotRequest random_balls(Random& random, BallFamily family);

/// Fifteen balls racked on pool-9ft, each `gap` metres from the next, and the cue ball sent at them from anywhere
/// behind the line, hard.
ShotRequest break_shot(Random& random, double gap);

}  // namespace bankshot::test
