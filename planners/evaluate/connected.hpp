// SPDX-License-Identifier: MIT
//
// Shots that are one: by the same route, and all launches between them are made as well.
#pragma once

#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Keeps of each such group the first. A few simulations for each two by one route.
void keep_connected_once(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots);

}  // namespace bankshot::planning
