// SPDX-License-Identifier: MIT
//
// The closest miss if there is no shot. Of launches inside all bounds it is the one that makes the bounces asked and
// passes, or rests, nearest to an aim point. If none makes them, it is the one that ends nearest.
// Method: a grid of aims and speeds and what the search remembers, then a compass search from the best few.
// Cost: settings::nearest, some 3,500 simulations, which do not count against the budget.
#pragma once

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning {

/// Returns none if no launch is allowed; without `scan` only what the search remembers is tried.
std::optional<Launch> nearest_launch(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found,
                                     bool scan);

}  // namespace bankshot::planning
