// SPDX-License-Identifier: MIT
//
// Questions changed in ways of which it is known what they do to the answer.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "support/random_question.hpp"

namespace bankshot::test {

/// A question, and what widens it in one way: a merge patch (RFC 7396).
struct Widening {
  std::string way;  ///< speed, angle, spin, arrive, cushions, then_cushions, ball, pocket, budget
  Json narrow, patch;
};

/// Narrows a question and says how to widen it again; none where the way drawn does not fit it. `way`: only that.
std::optional<Widening> random_widening(Random& random, const Json& question, std::string_view way = "");

/// The question as patched.
Json patched(Json question, const Json& patch);

/// x: left and right swap; y: bottom and top; both: half a turn. The answer is the mirrored one.
enum class Mirrored { x, y, both };
Json mirrored(const Json& question, Mirrored how);
/// The aim of the mirrored shot [rad].
double mirrored_aim(double aim, Mirrored how);

/// The same with `others` in the opposite order.
Json reordered(Json question);

}  // namespace bankshot::test
