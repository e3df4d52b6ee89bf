// SPDX-License-Identifier: MIT
//
// `success` where a player errs also in spin, or does not know exactly where the balls are or what the table does (a
// physics with a covariance): the share that is made of
// draws of all errors at once, spread evenly by an additive sequence (the fractional parts of i φ⁻ᵏ, φ^(d+1) = φ + 1
// for d errors), the same for every shot.
// Error: what is random in such a share of settings::all_errors::draws, 0.004 at most by one standard deviation; less
// where few errors count. Balls that a draw puts beyond a cushion or into each other are moved apart again, just so far
// that they touch.
#pragma once

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot);

}  // namespace bankshot::planning
