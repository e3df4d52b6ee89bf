// SPDX-License-Identifier: MIT
//
// Properties of answers that hold for every question, each as a case that can be drawn, checked and made smaller.
//   a  a wider question is never answered worse by more than 0.01 of value, unless its budget ended
//   b  `safest` has at least the value of `centre`
//   c  the first of `--all` has the value of the best
//   d  the mirrored question has the mirrored answer
//   e  the order of `others` changes nothing
//   f  a ball that no path comes near changes nothing: its value is not lower by more than 0.01, and where the launch
//      is another, not by more than 0.001. Near is 4 R, of the paths of all balls in the best shot and in 300 noisy
//      plays of it. Only where the target does not leave open which ball it is.
//   g  what `generate` makes and `solve` answers holds in 50 digits
//   h  `success` is the share of 2,000 noisy plays that count
// Values are success less `cost_of`; where success is counted over draws, three of its standard errors are allowed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "support/changed_question.hpp"

namespace bankshot::test {

inline constexpr std::string_view all_properties = "abcdefgh";
std::string_view about(char property);

/// One question, and what is done to it.
struct Case {
  char property = 'a';
  Json question, change = Json::object();
};

struct Outcome {
  bool judged = false;  ///< the property says something of this case
  bool failed = false;
  double off = 0;  ///< of value or success, what the property forbids: above 0 is worse
  std::string what{};
  std::vector<Json> questions{};
  std::vector<double> values{};
};

/// None where the draw does not lend itself to the property.
std::optional<Case> random_case(char property, Random& random, const QuestionWish& wish = {});

/// Solves what the case asks, and compares.
Outcome check(const Case& c);

/// A smaller case that still fails, and is at least half as far `off`: fewer balls, fewer keys, rounder numbers.
/// `most`: cases to check.
Case smaller(Case failing, double off, int most);

/// success − cost, 0 without a shot.
double value_of(const Answer& answer);

}  // namespace bankshot::test
