// SPDX-License-Identifier: MIT
//
// Shots that are one: they have the same route, and all launches between them are made as well.
#pragma once

#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Keeps the first shot of each such group. Cost: a few simulations for each two shots by one route.
void keep_connected_once(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots);

}  // namespace bankshot::planning
