// SPDX-License-Identifier: MIT
//
// Where to aim in an image: a point on the mark's exact line (geometry/opening.hpp) that a straight ray from the ball
// follows. On the table, seen back from the mark, all rays from the ball come from one place, so the line of a given
// offset is a tangent from there to a circle around the mark. Onto a ball the offset is given; into a pocket it depends
// on the direction: from the mark's middle on, each is corrected by the other. A turn moves the line by no more than
// the pocket's size and the direction by that over the distance, so a few turns end it, unless the ball is as near as
// the pocket is wide.
#pragma once

#include "bankshot/scene/target.hpp"
#include "planners/images/affine.hpp"

namespace bankshot::planning {

/// On the table [m], as a ball at `from` sees the mark in an image.
Vec2d on_exact_line(const Mark& mark, const Affine& image, const Vec2d& from);

}  // namespace bankshot::planning
