// SPDX-License-Identifier: MIT
//
// First-order results, from the derivatives of one locked path: how the arrival moves with aim and speed, its
// condition, its margin and its success estimate.
// Limits of the estimate: the target's two sides (of a pocket, as far as a ball's centre can go), the speed that just
// gets there, pockets and vertices beside the legs, and the ends of cushions where their order is asked.
// Error: the estimate is mostly near success. It may be far off for points beside a cushion line and at reflex
// vertices. success_at_most (rank.cpp) is the bound to build on.
// Cost: one simulation with dual numbers. Its work is counted; the caller decides whether it counts against a budget.
#pragma once

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/plan/shot.hpp"
#include "planners/evaluate/limits.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

struct FirstOrder {
  Vec2d by_angle{};             ///< m/rad, see Verification::by_angle
  Vec2d by_log_speed{};         ///< m per unit of ln speed
  double margin = 0;            ///< in standard deviations, see Robustness::first_order
  double success_estimate = 0;  ///< see Robustness::success_estimate
};

/// Returns the probability that errors leave the arrival on the aim point, if nothing else limits it. It is not less
/// than that of the root beside a launch, as the derivatives of its residuals say.
double success_on_aim_point(const Branch& aim, const Launch& launch, const Linear& linear);

/// Returns the probability that errors lead a launch past an aim point, at any speed. `linear`: its residuals there.
double estimate_of_passing(const SearchRequest& request, const AimPoint& aim_point, const Launch& launch,
                           const Linear& linear);

/// Returns the limits of a launch along a route, where errors are counted in units of `unit`; none where the path never
/// gets to its last leg.
std::optional<Limits> limits_of(const Branch& aim, const Launch& launch, const Noise& unit, Work& work);

/// Returns the success estimate of a shot once its aim is moved to the middle of what its target offers. Cost: one
/// simulation with dual numbers.
double estimate_in_middle(const SearchRequest& request, const Shot& shot, Work& work);

/// Fills `by_angle`, `by_speed`, `condition`, `first_order` and `success_estimate`.
void add_first_order(const SearchRequest& request, Shot& shot, Work& work);

}  // namespace bankshot::planning
