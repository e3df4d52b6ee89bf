// SPDX-License-Identifier: MIT
//
// Balls that move in the picture.
#pragma once

#include "bankshot/simulate/trajectory.hpp"
#include "draw/canvas.hpp"

namespace bankshot::drawing {

/// All balls of a shot, until all rest, in real time and over and over; where nothing moves, as on paper, they stand
/// where they begin.
void draw_moving(Canvas& c, const ShotRequest& request);

}  // namespace bankshot::drawing
