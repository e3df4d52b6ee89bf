// SPDX-License-Identifier: MIT
//
// The truth about a shot with other balls: the simulator of many balls, in 50 digits from the same double start.
#pragma once

#include <vector>

#include "bankshot/simulate/many_balls.hpp"
#include "truth/run.hpp"

namespace bankshot::truth {

/// An event of a ball; of two that meet, of the first.
struct BallTruth {
  BallEvent event;
  double time;
  Vec2d at, velocity;
};

/// A run where all balls move, see run.hpp.
Path run_all_truth(const Run& run);
Path run_all_double(const Run& run);

/// The first events, at most so many. `turned` [rad]: the launch is turned by this, without rounding.
std::vector<BallTruth> run_many_truth(const ShotRequest& request, std::size_t most, double turned = 0);
/// The same in double.
std::vector<BallTruth> run_many_double(const ShotRequest& request, std::size_t most);

}  // namespace bankshot::truth
