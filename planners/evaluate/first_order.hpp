// SPDX-License-Identifier: MIT
//
// What the derivatives of one locked path say of a shot: how the arrival moves with aim and speed, its condition, and
// to first order its margin and its success estimate. Limits of the estimate: the target's two sides (of a pocket, as
// far as a ball's centre can go), the speed that just gets there, pockets and vertices beside the legs, the ends of
// cushions where their order is asked.
// How near: of 1,832 shots of random puzzles (every family of tables; ideal, rolling, spin) the estimate is half of the
// time within 0.0003 of success, in nine of ten within 0.002. Far off are points beside a cushion line and reflex
// vertices, by 0.5 at most; success_at_most (rank.cpp) is the bound to build on. Cost: one simulation with dual
// numbers. Its work is counted; whether it is charged to a budget is up to the caller.
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

/// The probability that errors leave the arrival on the aim point, whatever else limits it: not less than that of the
/// root beside a launch, as the derivatives of its residuals say.
double success_on_aim_point(const Branch& aim, const Launch& launch, const Linear& linear);

/// The probability that errors lead a launch past an aim point that it sees so, at any speed.
double estimate_of_passing(const SearchRequest& request, const AimPoint& aim_point, const Launch& launch,
                           const Linear& linear);

/// What limits a launch along a route, where errors are counted in units of `unit`; none where the path never gets to
/// its last leg.
std::optional<Limits> limits_of(const Branch& aim, const Launch& launch, const Noise& unit, Work& work);

/// Of a shot, once its aim is moved to the middle of what its target offers. One simulation with dual numbers.
double estimate_in_middle(const SearchRequest& request, const Shot& shot, Work& work);

/// Fills `by_angle`, `by_speed`, `condition`, `first_order` and `success_estimate`.
void add_first_order(const SearchRequest& request, Shot& shot, Work& work);

}  // namespace bankshot::planning
