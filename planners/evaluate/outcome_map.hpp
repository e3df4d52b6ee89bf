// SPDX-License-Identifier: MIT
//
// The launches around a shot that make its target, found once, so that the value of any of them costs no simulation.
// Method: the outcome map tries aims at several launch speeds and bisects every change between them. The success of a
// launch is the sum over the intervals that are made, weighed by the player's normal errors. A first look at all
// allowed speeds is coarse; the map is then refined around the best one. Speeds and aims lie on a lattice which the
// shot does not move. So all shots of one region lead to one map and to the same safest launch, and a mirrored shot to
// its mirror image. An interval between two aims is missed, so the result is an estimate. Cost: some twenty simulations
// for each of twenty speeds.
#pragma once

#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

struct LikelyLaunch {
  Launch launch;
  double value = 0;  ///< to the map
};

/// Returns launches around a shot, inside the puzzle's bounds, best first: the one of the largest value, and those of
/// other speeds. None where nothing is made, or where the first look at all speeds leaves no hope of a value of
/// `worth`. `request` has the spin of the shot.
std::vector<LikelyLaunch> likely_launches(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot,
                                          double worth);

}  // namespace bankshot::planning
