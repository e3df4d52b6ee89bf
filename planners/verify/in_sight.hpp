// SPDX-License-Identifier: MIT
//
// Tells whether balls hide another one.
// Method: the ball that a straight path touches first changes only at an edge of a ball, or where two are touched at
// once. So one path between each two such directions tells of all. Cost: about 1 µs with few obstacles.
#pragma once

#include <span>

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::planning {

/// Returns whether some straight path from `from` touches `ball` before all `others`. Circles have the radius at which
/// centres touch.
bool in_sight(const Vec2d& from, const Circle& ball, std::span<const Circle> others);

}  // namespace bankshot::planning
