// SPDX-License-Identifier: MIT
//
// The point to aim at in an image. It lies on an exact line (geometry/opening.hpp), which a straight ray from the ball
// follows. On the table, seen back from the aim point, all rays from the ball come from one place. So the line with a
// given offset is a tangent from there to a circle around the aim point. Onto a ball the offset is given. Into a pocket
// it depends on the direction. Starting at the pocket's middle, offset and direction correct each other in turn. A
// correction moves the line by no more than the pocket's size, and the direction by that over the distance. So a few
// corrections suffice, unless the ball is as near as the pocket is wide.
#pragma once

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/scene/target.hpp"
#include "planners/propose/affine.hpp"

namespace bankshot::planning {

/// Returns the point on the table [m], as a ball at `from` sees the aim point in an image.
Vec2d on_exact_line(const AimPoint& aim_point, const Affine& image, const Vec2d& from);

}  // namespace bankshot::planning
