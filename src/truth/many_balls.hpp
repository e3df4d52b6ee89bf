// SPDX-License-Identifier: MIT
//
// The truth about a shot with other balls: the simulator of many balls, run in 50 digits from the same double start.
#pragma once

#include <vector>

#include "bankshot/simulate/many_balls.hpp"
#include "truth/run.hpp"

namespace bankshot::truth {

/// An event of a ball; for a collision, that of the first ball.
struct BallTruth {
  BallEvent event;
  double time;
  Vec2d at, velocity;
};

/// Run a shot in which all balls move (see run.hpp).
Path run_all_truth(const Run& run);
Path run_all_double(const Run& run);

/// Returns the first events, up to `most`. The launch is turned by `turned` [rad] without rounding.
std::vector<BallTruth> run_many_truth(const ShotRequest& request, std::size_t most, double turned = 0);
/// Returns the first events of the run in double.
std::vector<BallTruth> run_many_double(const ShotRequest& request, std::size_t most);

}  // namespace bankshot::truth
