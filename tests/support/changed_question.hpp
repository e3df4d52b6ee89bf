// SPDX-License-Identifier: MIT
//
// Changes puzzles in ways whose effect on the answer is known.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "support/random_question.hpp"

namespace bankshot::test {

/// A puzzle, and a merge patch (RFC 7396) that widens it in one respect.
struct Widening {
  std::string way;  ///< what is widened: speed, angle, spin, arrive, cushions, then_cushions, ball, pocket or budget
  Json narrow, patch;
};

/// Narrows a puzzle and returns the patch that widens it again; returns none when that widening does not fit the
/// puzzle. An empty `way` draws one.
std::optional<Widening> random_widening(Random& random, const Json& question, std::string_view way = "");

/// Returns the puzzle with the patch applied.
Json patched(Json question, const Json& patch);

/// x swaps left and right, y swaps bottom and top, and both is half a turn. The answer of a mirrored puzzle is the
/// mirrored answer.
enum class Mirrored { x, y, both };
Json mirrored(const Json& question, Mirrored how);
/// Returns the aim of the mirrored shot [rad].
double mirrored_aim(double aim, Mirrored how);

/// Returns the puzzle with `others` in reverse order.
Json reordered(Json question);

}  // namespace bankshot::test
