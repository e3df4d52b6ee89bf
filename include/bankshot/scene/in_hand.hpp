// SPDX-License-Identifier: MIT
//
// Ball in hand: the places in which a player may put the cue ball.
#pragma once

#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Returns whether the cue ball may stand here: in its region, clear of cushions and balls, and in no pocket.
/// `boundary` is that of the cue ball.
bool may_place(const Puzzle& puzzle, const Boundary& boundary, const Vec2d& at);

/// Returns the places on a grid of this step [m], row by row from the lower left.
std::vector<Vec2d> free_places(const Puzzle& puzzle, double step);

/// Returns the puzzle with the cue ball placed here.
Puzzle placed(Puzzle puzzle, const Vec2d& at);

}  // namespace bankshot
