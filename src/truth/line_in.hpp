// SPDX-License-Identifier: MIT
//
// Finds lines that lead straight into a pocket by trying single lines against the definitions of opening and exact
// line.
#pragma once

#include <optional>

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::truth {

/// Returns the least clearance [m] of a ball on a line with this offset; negative if it touches an obstacle. It is
/// taken where the centre enters the pocket's circle and, with jaws, from where it leaves the table. Returns none if no
/// ball can come along the line.
std::optional<double> room_of_line(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double offset);

/// Returns the offset of a pocket's exact line [m]; NaN if no line leads straight in. By definition, it tries lines
/// farther and farther beside the ball's own, up to the last that enters where a ball's centre can be. `heading` need
/// not be a unit vector.
double exact_offset(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double own);

}  // namespace bankshot::truth
