// SPDX-License-Identifier: MIT
//
// Animates balls in the picture.
#pragma once

#include "bankshot/simulate/trajectory.hpp"
#include "io/draw/canvas.hpp"

namespace bankshot::drawing {

/// Draws all balls of a shot, moving in real time until all rest, and then again. Without animation, as on paper, they
/// are at their start positions.
void draw_moving(Canvas& c, const ShotRequest& request);

}  // namespace bankshot::drawing
