// SPDX-License-Identifier: MIT
//
// Moves balls apart whose measured positions overlap a little, so that the scene can be simulated.
//   puzzle.settled = settle(puzzle.table, puzzle.ball, puzzle.others);
// Method: repeated sweeps over all pairs. Two overlapping balls are pushed apart along their line of centres, each by
// half, and off cushions. The sweeps end when no two balls overlap by more than tolerance::overlap.
#pragma once

#include <vector>

#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"

namespace bankshot {

/// Moves the balls and returns their displacements [m], the cue ball first. No ball moves if two balls overlap by more
/// than tolerance::settled_overlap or if there is no room; `validate` then names the balls.
std::vector<Vec2d> settle(const Table& table, Ball& cue, std::vector<Ball>& others);

}  // namespace bankshot
