// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/shot.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Returns the value by which a shot ranks: below all others where the cue ball falls, and below any where the value is
/// not known.
double worth_of(const Shot& shot);

/// Moves a shot inside what is made to where its value is largest (outcome_map.hpp). The moved launch is verified with
/// every bound of the puzzle, and replaces the shot if its own success makes it the better one. Such a shot is `moved`,
/// and its miss is no longer 0. Success and value of the shot are known afterwards. Returns false and does nothing
/// where there is no hope of a value of `worth`.
bool make_safest(const SearchRequest& request, EvaluationBudget& budget, Shot& shot, double worth = -1);

}  // namespace bankshot::planning
