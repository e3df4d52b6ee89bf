// SPDX-License-Identifier: MIT
//
// Every claim of an answer, held against a replay in 50 digits.
// What may differ: a place by `exact_miss` of the diagonal or, where the shot promises fewer `digits`, by as many of
// the diagonal (of a shot that promises none its bounds alone are held to it); a time by that place at the ball's
// speed; a speed on arrival by `exact_speed`, or as many digits; a condition by 1e-6 or, where there are fewer digits,
// by that place over the ball's radius. With mathavan2010 the impacts of the replay are integrated 1e7 times finer than
// those of the solver.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/answer.hpp"

namespace bankshot::truth {

enum class Claim {
  id,         ///< that of the puzzle
  form,       ///< the answer has what its status says: shots when solved, none when not
  status,     ///< a puzzle that cannot be read is `invalid`, and no other
  speed,      ///< launch speed inside the puzzle's bounds [m/s]
  angle,      ///< aim inside the puzzle's bounds [rad]
  spin,       ///< the spin asked, or one inside the ranges asked
  rule,       ///< the cushions are as the puzzle asks
  cushions,   ///< the ball meets the cushions named, in that order
  target,     ///< the target is made: nothing is in the way, no other pocket takes the ball
  centre,     ///< exactly, unless the shot says that it is off centre [m]
  miss,       ///< [m]
  offset,     ///< of the line of travel from the pocket's centre [m]
  hits,       ///< the contact with the ball that is its target: cut, place [m], speed [m/s]
  place,      ///< where it arrives [m]
  time,       ///< when [s]
  arrival,    ///< how fast [m/s]
  asked,      ///< as fast as the puzzle asks [m/s]
  condition,  ///< by differences in 50 digits [relative]
  margin,     ///< made just inside, not made just outside, all 0 of a scratch [number of ends that are wrong]
  success,    ///< between 0 and 1, and as 1,000 seeded draws say
  value,      ///< success less what the shot costs
};
inline constexpr int claims = 21;

std::string_view name(Claim claim);
std::string_view unit(Claim claim);  ///< of `off` and `allowed`

/// One claim of one shot. It holds when off <= allowed.
struct Check {
  Claim claim;
  double off = 0, allowed = 0;
  std::string what{};    ///< in words, where it does not hold
  std::size_t shot = 0;  ///< which of the answer's; 0 is the best
  bool holds() const { return off <= allowed; }
};

/// Checks of all shots, in their order. `puzzle` is null where it cannot be read; `id` is its JSON text.
std::vector<Check> check(const Puzzle* puzzle, const std::string& id, const Answer& answer);

}  // namespace bankshot::truth
