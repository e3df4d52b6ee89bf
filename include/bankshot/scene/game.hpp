// SPDX-License-Identifier: MIT
//
// Games, as far as they decide which ball may be potted next. "What should I play?" is then a puzzle like others: to
// pot a ball that the game allows now, and to leave the cue ball for the next one.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Balls 1 to 7 and 9 to 15, by their numbers.
enum class Group { solids, stripes };

/// Returns the order of `rotation` or `any` for these balls. Throws InvalidInput if a ball of `rotation` has no number.
PottingOrder order_of(Game game, std::span<const Ball> others);
/// Returns the order of `eight`: the balls of the player's group, and then ball 8. Throws InvalidInput if a ball has
/// no number, or there is no ball 8.
PottingOrder order_of_eight(Group own, std::span<const Ball> others);

/// Returns the player's group of a puzzle of `eight`; if it is none but the 8, the group of which no ball is left.
Group own_group(const Puzzle& puzzle);

/// Makes a puzzle ask what to play in a game whose balls are potted in this order: sets its target and its leave.
void ask(Puzzle& puzzle, Game game, const PottingOrder& order);
/// Returns the order of a puzzle that asks what to play.
const PottingOrder& order_of(const Puzzle& puzzle);

/// Returns the order in which the opponent pots: the same, but in `eight` that of the other group.
PottingOrder opponents_order(const Puzzle& puzzle);
/// Returns the question of a safety: to touch a ball that the game allows, and to leave the opponent no pot.
Puzzle as_safety(Puzzle puzzle);

/// Returns the order as balls that fell leave it. `places` are those of all balls, the cue ball first; none: it fell.
PottingOrder left_of(const PottingOrder& order, std::span<const std::optional<Vec2d>> places);
/// Returns the question after a shot that left the balls at these places: without those that fell, and with the next
/// balls to pot; none where no ball is left to pot, or the cue ball fell.
std::optional<Puzzle> next_question(const Puzzle& puzzle, std::span<const std::optional<Vec2d>> places);

}  // namespace bankshot
