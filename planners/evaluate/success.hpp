// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/shot.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Finds `success`: the probability that the target is made by any allowed cushions, under the player's errors.
/// success.cpp says how it is found. It takes about settings::success::most_samples_of_balls simulations at most, fewer
/// where the budget ends.
void find_success(const SearchRequest& request, EvaluationBudget& budget, Shot& shot);

}  // namespace bankshot::planning
