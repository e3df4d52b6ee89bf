// SPDX-License-Identifier: MIT
//
// The leave: the place in which the cue ball should come to rest after a shot, as a puzzle asks for it.
#pragma once

#include <variant>
#include <vector>

#include "bankshot/numbers/vec.hpp"

namespace bankshot {

/// At this point, or within this distance of it.
struct LeavePlace {
  Vec2d at{};
  double within = 0.1;  ///< m
};

/// Inside this polygon; its vertices go once around, in either direction.
struct LeaveRegion {
  std::vector<Vec2d> vertices{};  ///< m
};

/// A place from which the best pot of this ball is likely.
struct LeaveForBall {
  int ball = 0;  ///< k stands for the k-th of `others`, from 1
};

/// A place from which none of these balls can be hit directly: a snooker.
struct LeaveSafe {
  std::vector<int> balls{};  ///< as in LeaveForBall
};

using Leave = std::variant<LeavePlace, LeaveRegion, LeaveForBall, LeaveSafe>;

/// Returns the distance [m] of a point from a region; 0 inside.
double distance_to(const LeaveRegion& region, const Vec2d& at);
/// Returns how far [m] a cue ball that rests here is from the place or the region; 0 if neither is asked for.
double miss_of(const Leave& leave, const Vec2d& at);

}  // namespace bankshot
