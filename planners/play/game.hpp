// SPDX-License-Identifier: MIT
//
// The answer to "what should I play?" in a game: the pot that most likely also leaves the next one, the shots planned
// after it, and a safety where a pot would leave the opponent more than it wins.
// Method: the puzzle of the first shot is solved as any with a leave, then that of the layout which it leaves, and so
// on. Guarantee: each shot is verified by replay; the probabilities of the later balls are estimates.
#pragma once

#include "bankshot/plan/planner.hpp"

namespace bankshot::planning::play {

/// Solves a puzzle that asks what to play.
Answer solve_game(const Puzzle& puzzle, const SolveOptions& options);

}  // namespace bankshot::planning::play
