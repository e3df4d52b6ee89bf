// SPDX-License-Identifier: MIT
//
// The diamonds, and where a line of aim crosses the rail that carries them. They stand behind the cushions: who aims
// over the ball at a diamond looks 3 11/16 inches beyond the nose, so the place on the nose line is not what is named.
// Numbers run from 0 at the corner on the left or at the bottom, to 8 on long rails and 4 on short ones.
#pragma once

#include <optional>

#include "bankshot/scene/table.hpp"

namespace bankshot {

/// How far the diamonds' centres lie behind the nose line [m]: 3 11/16 inches by the WPA's equipment specification,
/// the only rule that gives a distance (the UMB's and snooker's do not); on a table smaller than any that is sold, in
/// proportion.
double sight_distance(const Table& table);

/// Spaces between diamonds along a cushion of a rectangle: 8 on the long ones, 4 on the short.
int diamonds_along(const Table& rectangle, int cushion);

struct Sight {
  int cushion;
  Vec2d at;         ///< where the line crosses the line of diamonds; of a polygon, which has none, the nose line [m]
  double part;      ///< of the cushion, from the left or the bottom; of a polygon from its first vertex
  double diamonds;  ///< the same in diamonds; 0 of a polygon
};

/// Along the unit vector `aim` from a ball at `from`; none where the line leaves the table nowhere.
std::optional<Sight> sight(const Table& table, const Vec2d& from, const Vec2d& aim);

}  // namespace bankshot
