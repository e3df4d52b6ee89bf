// SPDX-License-Identifier: MIT
//
// The worth of a leave: 1 where the cue ball stops as the puzzle asks, 0 elsewhere; with `for` the chance of the best
// pot of that ball.
#pragma once

#include <optional>
#include <span>

#include "planners/play/next_pot.hpp"

namespace bankshot::planning::play {

class LeaveWorth {
 public:
  /// The puzzle has a leave, and outlives this.
  explicit LeaveWorth(const Puzzle& puzzle) : puzzle_(puzzle), next_(puzzle) {}

  /// From 0 to 1; `places` as in NextPot::best.
  double operator()(std::span<const std::optional<Vec2d>> places) const;

 private:
  const Puzzle& puzzle_;
  NextPot next_;
};

}  // namespace bankshot::planning::play
