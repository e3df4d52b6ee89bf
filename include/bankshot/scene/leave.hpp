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

/// The order in which balls are to be potted: those of the first group in any order, then those of the second, and so
/// on; k stands for the k-th of `others`, from 1.
using PottingOrder = std::vector<std::vector<int>>;

/// A place from which the best pot of a next ball is likely: of the first group of which a ball is left.
struct LeaveForNext {
  PottingOrder order{};
  int plies = 1;  ///< pots that count in the choice: 1: the next; 2: also the best one after it
};

/// A place from which none of these balls, which all stay on the table, can be hit directly: a snooker.
struct LeaveSafe {
  std::vector<int> balls{};  ///< as in PottingOrder
};

/// A place from which the best pot of a next ball is unlikely: a safety. The order is that of the opponent.
struct LeaveAgainst {
  PottingOrder order{};
};

using Leave = std::variant<LeavePlace, LeaveRegion, LeaveForNext, LeaveSafe, LeaveAgainst>;

/// Returns the distance [m] of a point from a region; 0 inside.
double distance_to(const LeaveRegion& region, const Vec2d& at);
/// Returns how far [m] a cue ball that rests here is from the place or the region; 0 if neither is asked for.
double miss_of(const Leave& leave, const Vec2d& at);

}  // namespace bankshot
