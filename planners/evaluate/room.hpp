// SPDX-License-Identifier: MIT
//
// The interval that a target offers beside a shot.
#pragma once

#include "bankshot/geometry/aim_point.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Returns how far the arrival may move along the unit vector `way`, across the line of travel [m]: back to `low`, on
/// to `high`. For a pocket it stays inside the gap of the line's direction; for a point, inside its disc.
inline Gap<double> room_beside(const SearchRequest& request, const Shot& shot, const Vec2d& way) {
  const AimPoint& aim_point = request.problem->aim_point_of(shot);
  const Vec2d off = aim_point.at - shot.path.arrival.at;
  // The line of travel leads to the pocket, so the sign tells on which side of it `way` is.
  const bool to_right = aim_point.captures() && cross(off, way) < 0;
  const Vec2d left = to_right ? -way : way;
  const double at = -dot(left, off);
  if (!aim_point.captures()) return {-aim_point.reach - at, aim_point.reach - at};
  const Gap<double> gap = aim_point.gap(Vec2d{left.y, -left.x}, at);
  return to_right ? Gap<double>{at - gap.high, at - gap.low} : Gap<double>{gap.low - at, gap.high - at};
}

}  // namespace bankshot::planning
