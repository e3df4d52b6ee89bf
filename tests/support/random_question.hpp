// SPDX-License-Identifier: MIT
//
// Random questions as a user would type them: JSON, as wide as the format allows, whether there is a shot or not.
// Seeded; nothing of the planners.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

using Json = nlohmann::json;

struct QuestionWish {
  int most_balls = 15;       ///< object balls; one question in twenty has more than three
  bool quick = false;        ///< presets and rectangles, one or two balls, noise of aim and speed alone, small budgets
  bool robust_only = false;  ///< no other `prefer`
};

/// Always valid: draws until the reader and `validate` take it.
Json random_question(Random& random, const QuestionWish& wish = {});

/// As `solve` would read it; none where that is invalid.
std::optional<Puzzle> valid_puzzle(const Json& question);

/// m, to a millimetre.
double in_millimetres(double metres);

/// Some rule for up to `most` cushions: a number, bounds or names.
Json random_cushion_rule(Random& random, const Table& table, int most);

/// A ball at rest on a free place of the table, to a millimetre; none in a hundred draws.
std::optional<Vec2d> free_place(Random& random, const Table& table, std::span<const Ball> others, const Body& body);

}  // namespace bankshot::test
