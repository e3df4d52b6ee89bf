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

/// Returns `success` for a player who errs also in spin, or does not know exactly where the balls are or what the table
/// does (a physics with a covariance). It is the share of plays that make the target. An additive sequence spreads the
/// draws of all errors evenly (draws.hpp), and is the same for every shot.
/// Error: the standard deviation of such a share is at most 0.004 for settings::all_errors::draws, less where few
/// errors count. Balls that a draw puts beyond a cushion or into each other are moved apart again, just so far that
/// they touch.
double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot);

}  // namespace bankshot::planning
