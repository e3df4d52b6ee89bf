// SPDX-License-Identifier: MIT
//
// What a target offers beside a shot.
#pragma once

#include "planners/question.hpp"

namespace bankshot::planning {

/// How far the arrival may move along the unit vector `way`, across the line of travel [m]: back to `low`, on to
/// `high`. Of a pocket, inside the gap of the line's direction; of a point, its disc.
inline Gap<double> room_beside(const Question& q, const Shot& shot, const Vec2d& way) {
  const Mark& mark = q.mark_of(shot);
  const Vec2d off = mark.at - shot.arrival.at;
  // The line of travel leads to the pocket, so the sign tells on which side of it `way` is.
  const bool to_right = mark.captures() && cross(off, way) < 0;
  const Vec2d left = to_right ? -way : way;
  const double at = -dot(left, off);
  if (!mark.captures()) return {-mark.reach - at, mark.reach - at};
  const Gap<double> gap = mark.gap(Vec2d{left.y, -left.x}, at);
  return to_right ? Gap<double>{at - gap.high, at - gap.low} : Gap<double>{gap.low - at, gap.high - at};
}

}  // namespace bankshot::planning
