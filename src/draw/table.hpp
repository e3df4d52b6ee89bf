// SPDX-License-Identifier: MIT
//
// The empty table: rails, cushions, cloth, pockets cut into the rails, diamonds with their numbers, names; and what a
// puzzle asks for on it.
#pragma once

#include <optional>

#include "answer/sights.hpp"
#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "draw/canvas.hpp"

namespace bankshot::drawing {

/// `words`: names and numbers. The number of a diamond gives way to that of the line of aim next to it.
void draw_table(Canvas& c, bool words, const std::optional<Sight>& aim = {});

/// Once more, over whatever covers them.
void draw_holes(Canvas& c);

/// Of several pockets only `reached`, where one was.
void draw_target(Canvas& c, const Puzzle& puzzle, const Pocket* reached = nullptr);

/// Of the pocket that a shot falls into: the lines beside its own that lead straight in, as a bar across the mouth.
/// `heading`: as it arrives.
void draw_opening(Canvas& c, const Puzzle& puzzle, const Shot& shot, const Vec2d& heading);

}  // namespace bankshot::drawing
