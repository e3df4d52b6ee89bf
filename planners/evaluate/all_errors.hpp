// SPDX-License-Identifier: MIT
//
// `success` for a player who errs also in spin, or does not know exactly where the balls are or what the table does (a
// physics with a covariance). It is the share of plays that make the target. An additive sequence spreads the draws of
// all errors evenly (draws.hpp), and is the same for every shot.
// Error: the standard deviation of such a share is at most 0.004 for settings::all_errors::draws, less where few errors
// count. Balls that a draw puts beyond a cushion or into each other are moved apart again, just so far that they touch.
#pragma once

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot);

}  // namespace bankshot::planning
