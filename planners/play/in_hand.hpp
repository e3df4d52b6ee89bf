// SPDX-License-Identifier: MIT
//
// Ball in hand: the place of the cue ball from which the puzzle's best shot is best.
// Method: places on a grid, those first from which the target's balls have the surest straight pot (next_pot.hpp). The
// puzzle is solved from the best of them, and a compass search over the place improves the best (Kolda, Lewis &
// Torczon, SIAM Review 45, 2003, algorithm 3.2).
// Cost: some twenty to forty puzzles. Guarantee: none; a test compares it with a coarse grid.
#pragma once

#include "bankshot/plan/planner.hpp"

namespace bankshot::planning::play {

/// Solves a puzzle whose cue ball is in hand. All shots of the answer have one place.
Answer solve_in_hand(const Puzzle& puzzle, const SolveOptions& options);

}  // namespace bankshot::planning::play
