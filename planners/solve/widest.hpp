// SPDX-License-Identifier: MIT
//
// Finds the largest clearance around a candidate (trace/clearance.hpp), over aims at the speeds that arrive as asked.
// If that is positive, a shot is likely. Cost: some 100 simulations a candidate.
// Guarantee: none; what it finds is verified by a replay.
#pragma once

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning {

/// Finds the largest clearance, which the candidate's `room` receives; it may make a shot. Sets the candidate's `half`
/// where it is 0.
void climb_clearance(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Candidate& candidate);

}  // namespace bankshot::planning
