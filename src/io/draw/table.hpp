// SPDX-License-Identifier: MIT
//
// Draws the empty table (rails, cushions, cloth, pockets cut into the rails, diamonds with their numbers, names) and
// the target of a puzzle on it.
#pragma once

#include <optional>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "io/answer/sights.hpp"
#include "io/draw/canvas.hpp"

namespace bankshot::drawing {

/// Draws the table, with `words` also names and numbers. The number of a diamond is left out if the number of the line
/// of aim is next to it.
void draw_table(Canvas& c, bool words, const std::optional<Sight>& aim = {});

/// Draws the holes again, over elements that cover them.
void draw_holes(Canvas& c);

/// Draws the target. If `reached` is given, the other pockets are not marked.
/// Draws the place or the region where the cue ball should stop.
void draw_wanted_leave(Canvas& c, const Puzzle& puzzle);

/// Draws the ellipses inside which the cue ball stops in half and in nine tenths of the plays that make the target.
void draw_spread(Canvas& c, const Spread& spread);

void draw_target(Canvas& c, const Puzzle& puzzle, const Pocket* reached = nullptr);

/// Draws the gap of the pocket that a shot falls into, as a bar across the mouth. `heading` is the ball's velocity at
/// arrival.
void draw_opening(Canvas& c, const Puzzle& puzzle, const Shot& shot, const Vec2d& heading);

}  // namespace bankshot::drawing
