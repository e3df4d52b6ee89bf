// SPDX-License-Identifier: MIT
//
// Properties that answers of all puzzles must have, each as a case that can be drawn, checked and made smaller.
//   a  widening a puzzle never lowers the value of its answer by more than 0.01, unless the budget ended
//   b  `safest` has at least the value of `centre`
//   c  the first shot of `--all` has the value of the best shot
//   d  the answer of the mirrored puzzle has the same value
//   e  the order of `others` changes nothing
//   f  a far ball, 4 R or more from all paths, changes nothing: the value falls by at most 0.01, or by at most 0.001 if
//      the launch is another. The paths are those of all balls in the best shot and in 300 noisy plays of it. The
//      target must name its ball.
//   g  the answers to puzzles from `generate` hold in 50 digits
//   h  `success` is the share of 2,000 noisy plays that count, within four standard errors and 0.005
// Values are success less `cost_of`. Where success is counted over draws, a to f also allow three of its standard
// errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "support/changed_question.hpp"

namespace bankshot::test {

inline constexpr std::string_view all_properties = "abcdefgh";
std::string_view about(char property);

/// One puzzle, and the change made to it.
struct Case {
  char property = 'a';
  Json question, change = Json::object();
};

struct Outcome {
  bool judged = false;  ///< true when the property applies to this case
  bool failed = false;
  double off = 0;  ///< violation in value or success; above 0 is worse
  std::string what{};
  std::vector<Json> questions{};
  std::vector<double> values{};
};

/// Returns none when the draw does not suit the property.
std::optional<Case> random_case(char property, Random& random, const QuestionWish& wish = {});

/// Solves the puzzles of the case and compares the answers.
Outcome check(const Case& c);

/// Returns a smaller case that still fails and is at least half as far `off`, with fewer balls, fewer keys and rounder
/// numbers. `most` limits the number of cases to check.
Case smaller(Case failing, double off, int most);

/// Returns success − cost; 0 without a shot.
double value_of(const Answer& answer);

}  // namespace bankshot::test
