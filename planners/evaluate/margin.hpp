// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/shot.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Finds `margin`: the first launch, on either side, that is not made by the same cushions. It uses growing steps and
/// bisection to tolerance::margin. Cost: about 150 simulations.
void find_margin(const SearchRequest& request, EvaluationBudget& budget, Shot& shot);

}  // namespace bankshot::planning
