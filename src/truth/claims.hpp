// SPDX-License-Identifier: MIT
//
// Checks every claim of an answer against a replay in 50 digits. Allowed differences:
//   position   `exact_miss` of the diagonal; if the shot guarantees fewer `digits`, that many digits of the diagonal
//   time       the position error at the ball's speed
//   speed      on arrival, `exact_speed` or the guaranteed digits
//   condition  1e-6; with fewer digits, the position error over the ball's radius
// A shot that guarantees no digits is checked only for its bounds. Where impacts are integrated, the replay does so 1e7
// times finer than the solver.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/answer.hpp"

namespace bankshot::truth {

enum class Claim {
  id,         ///< the puzzle's id
  form,       ///< the answer matches its status: shots if solved, otherwise none
  status,     ///< `invalid` exactly if the puzzle cannot be read
  speed,      ///< launch speed inside the puzzle's bounds [m/s]
  angle,      ///< aim inside the puzzle's bounds [rad]
  spin,       ///< the required spin, or one inside the required ranges
  rule,       ///< the cushions satisfy the puzzle's rule
  cushions,   ///< the ball meets the named cushions in this order
  target,     ///< the target is made: no obstacle, and no other pocket takes the ball
  centre,     ///< the target is made exactly, unless the shot says that it is off centre [m]
  miss,       ///< distance from the point or exact line [m]
  offset,     ///< offset of the line of travel from the pocket's centre [m]
  hits,       ///< contacts with balls: cut and position [m], speed [m/s]
  place,      ///< position of the arrival [m]
  time,       ///< time of the arrival [s]
  arrival,    ///< speed on arrival [m/s]
  asked,      ///< speed on arrival inside the puzzle's range [m/s]
  condition,  ///< condition by differences in 50 digits [relative]
  margin,     ///< made just inside, not just outside; all 0 for a scratch [number of wrong ends]
  success,    ///< between 0 and 1, and consistent with 1,000 seeded draws
  value,      ///< success, or that of the leave, minus the cost of the shot
  leave,      ///< where the cue ball stops, in double, and how far from where it should [m]
};
inline constexpr int claims = 22;

std::string_view name(Claim claim);
std::string_view unit(Claim claim);  ///< unit of `off` and `allowed`

/// One claim of one shot. It holds when off <= allowed.
struct Check {
  Claim claim;
  double off = 0, allowed = 0;
  std::string what{};    ///< description if it does not hold
  std::size_t shot = 0;  ///< index among the answer's shots; 0 is the best
  bool holds() const { return off <= allowed; }
};

/// Returns the checks of the answer and of all its shots, in order. `puzzle` is null if it cannot be read; `id` is the
/// JSON text of its id.
std::vector<Check> check(const Puzzle* puzzle, const std::string& id, const Answer& answer);

}  // namespace bankshot::truth
