// SPDX-License-Identifier: MIT
//
// The worth of a leave: 1 where the cue ball stops as the puzzle asks, 0 elsewhere; with `for` the chance of the best
// pot of the next ball, with `against` one less that chance.
#pragma once

#include <optional>

#include "planners/play/next_pot.hpp"
#include "planners/verify/aftermath.hpp"

namespace bankshot::planning::play {

class LeaveWorth {
 public:
  /// The puzzle has a leave, and outlives this.
  explicit LeaveWorth(const Puzzle& puzzle) : puzzle_(puzzle), next_(puzzle) {}

  /// From 0 to 1. A safety without a cushion after the contact breaks the rules (WPA, World Standardized Rules 6.3).
  double operator()(const Ending& ending) const;
  /// Returns whether the cue ball stops there as asked; none if no place or region is asked for.
  std::optional<bool> is_inside(const Vec2d& at) const;
  const NextPot& next_pot() const { return next_; }

 private:
  const Puzzle& puzzle_;
  NextPot next_;
};

}  // namespace bankshot::planning::play
