// SPDX-License-Identifier: MIT
//
// Random puzzles as a user would type them: JSON, as wide as the format allows, with or without a shot. The draws are
// seeded and use nothing of the planners.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

using Json = nlohmann::json;

struct QuestionWish {
  int most_balls = 15;       ///< number of object balls; one puzzle in twenty has more than three
  bool quick = false;        ///< presets and rectangles, one or two balls, noise of aim and speed alone, small budgets
  bool robust_only = false;  ///< no other `prefer`
  bool leaves = false;       ///< each puzzle has a leave or asks for a game
};

/// Draws until the reader and `validate` accept the puzzle.
Json random_question(Random& random, const QuestionWish& wish = {});

/// Reads the puzzle as `solve` would; returns none when it is invalid.
std::optional<Puzzle> valid_puzzle(const Json& question);

/// Rounds to a millimetre [m].
double in_millimetres(double metres);

/// Draws a rule for up to `most` cushions: a number, bounds or names.
Json random_cushion_rule(Random& random, const Table& table, int most);

/// Draws a free place on the table for a ball at rest, rounded to a millimetre; returns none after a hundred failed
/// draws.
std::optional<Vec2d> free_place(Random& random, const Table& table, std::span<const Ball> others, const Body& body);

}  // namespace bankshot::test
