// SPDX-License-Identifier: MIT
//
// The words of an answer: what was found or searched, and which bound binds.
#pragma once

#include <string>

#include "bankshot/plan/answer.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning {

/// Returns the message. `distinct`: number of shots found, of which the answer may hold only the best.
std::string message(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found, const Answer& a,
                    std::size_t distinct);

/// Adds the closest miss of a search without a shot (nearest.hpp), replayed. `scan`: look beyond what the search met.
void add_nearest(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found, bool scan,
                 Answer& a);

}  // namespace bankshot::planning
