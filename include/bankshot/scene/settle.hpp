// SPDX-License-Identifier: MIT
//
// Balls whose measured places overlap a little are moved apart, so that the scene can be played.
//   puzzle.settled = settle(puzzle.table, puzzle.ball, puzzle.others);
// Method: sweeps over all pairs. Two that overlap are pushed apart along their line of centres, each by half, and back
// off cushions, until no two overlap by more than tolerance::overlap.
#pragma once

#include <vector>

#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"

namespace bankshot {

/// By how much each ball moved [m], the cue ball first. All stay where two overlap by more than
/// tolerance::settled_overlap, or have no room: `validate` then says which.
std::vector<Vec2d> settle(const Table& table, Ball& cue, std::vector<Ball>& others);

}  // namespace bankshot
