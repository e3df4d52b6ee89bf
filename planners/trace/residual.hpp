// SPDX-License-Identifier: MIT
//
// An aim point seen along a route: the smooth system whose roots are shots.
// Unknowns: aim [rad] and ln speed, or the aim alone where the launch speed is fixed.
// Residuals, as many:
//   to stop at a point   the aim point, less where the ball rests, over the diagonal
//   else                 [0] the signed lateral miss at the closest approach over the diagonal (of a pocket, of its
//                            exact line: geometry/opening.hpp),
//                        [1] v² − s² there (at capture for a pocket) over max(1, s²); v² is continued below 0, by what
//                            rolling on would have cost, when the ball rests before. Where rolling friction grows with
//                            the speed, both squares are counted by the metres to rest instead: v² bends like √v²
//                            near the rest, and Newton's method would not see slow passages
// Derivatives are exact (dual numbers); no type of the library that makes them appears here.
// Worked number: a ball rolls 1 m straight at its aim point, asked to pass it at 0.5 m/s, friction 0.01: from 1 m/s it
// passes with v² = 1 − 2 · 0.0981 · 1 = 0.804, so r = (0, 0.554); by ln speed r[1] grows by 2 v0² = 2, and one Newton
// step leads to 0.758 m/s, where v² = 0.379 and the root 0.668 m/s is another two steps away.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/locked.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {

inline constexpr std::size_t most_unknowns = 2;  ///< the aim, and ln speed

/// The causal ancestry of an arrival at an aim point: the ordered meetings that lead to it. What other balls do is
/// context. Legs are counted from 0; each ends at its meeting, the last one at the aim point.
struct Branch {
  const SearchRequest& request;
  std::span<const Meeting> route;
  AimPoint aim_point;

  int ball(std::size_t leg) const { return leg < route.size() ? route[leg].ball : aim_point.ball; }
  Contact next(std::size_t leg) const { return leg < route.size() ? route[leg].with : Contact{}; }
  std::span<const Meeting> before(std::size_t leg) const { return route.first(leg); }
};

/// Residuals and their derivatives at one launch: as many as there are unknowns, the rest is 0.
struct Linear {
  std::array<double, most_unknowns> r{};
  std::array<std::array<double, most_unknowns>, most_unknowns> by{};  ///< by[k][i]: of residual k by unknown i
  double time = 0;                                                    ///< s, of the arrival

  double by_aim(std::size_t k) const { return by[k][0]; }
  double by_speed(std::size_t k) const { return by[k][1]; }
  double size() const { return std::hypot(r[0], r[1]); }
  /// Returns a number whose sign changes across a fold of the map.
  double determinant(bool one_unknown) const {
    return one_unknown ? by[0][0] : by[0][0] * by[1][1] - by[1][0] * by[0][1];
  }
};

/// Simulates a locked path once with dual numbers; none where the path never gets to its last leg, or the budget is
/// spent. `roughly`: impacts are integrated no more finely than a seed needs.
std::optional<Linear> linearise(const Branch& aim, EvaluationBudget& budget, const Launch& launch,
                                bool roughly = false);

/// Returns by how much the squared speed of arrival exceeds the one asked [m²/s²], both as residual [1] counts them.
/// `square`: the squared launch speed. One locked simulation, no finer than a seed needs.
std::optional<double> excess_speed2(const Branch& aim, EvaluationBudget& budget, double angle, double square);

}  // namespace bankshot::planning
