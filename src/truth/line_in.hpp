// SPDX-License-Identifier: MIT
//
// Lines that lead straight into a pocket, by the definition of its opening and exact line: tried, one by one.
#pragma once

#include <optional>

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::truth {

/// How far a ball's centre keeps from what it may not touch, by less than 0 where it does [m]: on a line of this
/// offset, where it enters the pocket's circle and, with jaws, since it left the table; none where it cannot come from
/// there.
std::optional<double> room_of_line(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double offset);

/// The offset of a pocket's exact line [m], not a number where no line leads straight in; from its definition: lines
/// beside the ball's own enter farther and farther off, up to the last one that enters where a ball's centre can be.
/// `heading` need not be a unit vector.
double exact_offset(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double own);

}  // namespace bankshot::truth
