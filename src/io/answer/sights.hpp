// SPDX-License-Identifier: MIT
//
// Computes where a line of aim crosses the diamonds. The diamonds lie on the rails, 3 11/16 inches behind the cushion
// nose. A player aims over the ball at a diamond, so the crossing is computed there and not on the nose line. Numbers
// run from 0 at the left or bottom corner to 8 on long rails and to 4 on short ones.
#pragma once

#include <optional>

#include "bankshot/scene/table.hpp"

namespace bankshot {

/// Returns the distance of the diamonds' centres behind the nose line [m]. It is 3 11/16 inches by the WPA's equipment
/// specification, the only rule that gives a distance (the UMB's and snooker's do not). On tables smaller than any that
/// is sold it shrinks in proportion.
double sight_distance(const Table& table);

/// Returns the number of spaces between diamonds along a cushion of a rectangle: 8 on the long cushions, 4 on the short
/// ones.
int diamonds_along(const Table& rectangle, int cushion);

struct Sight {
  int cushion;
  Vec2d at;         ///< m; crossing with the line of diamonds, or with the nose line of a polygon
  double part;      ///< fraction of the cushion from the left or bottom; on a polygon, from its first vertex
  double diamonds;  ///< `part` in diamonds; 0 on a polygon
};

/// Returns the crossing along the unit vector `aim` from a ball at `from`; none if the line crosses no rail.
std::optional<Sight> sight(const Table& table, const Vec2d& from, const Vec2d& aim);

}  // namespace bankshot
