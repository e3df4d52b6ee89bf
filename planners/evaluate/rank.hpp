// SPDX-License-Identifier: MIT
//
// The choice of the answer among the shots found: their order by `prefer`, and margin and success where they are asked
// for.
#pragma once

#include <span>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning {

/// Returns the merit of a shot by `prefer`; larger is better. That of a robust shot is its first-order margin until its
/// value is known.
double merit(const Puzzle& puzzle, const Shot& shot);

/// Returns whether a shot comes before another one by `prefer`; one that scratches comes last.
bool comes_before(const Puzzle& puzzle, const Shot& a, const Shot& b);

/// Returns a bound on the success of a shot to an aim point with this success estimate, by settings::rank.
double success_at_most(const SearchRequest& request, const AimPoint& aim_point, double estimate);

/// Drops shots beside the exact line or point where others are on it, and orders the rest, best first.
void rank(const SearchRequest& request, std::vector<Shot>& shots);

/// Brings the shot with the largest value to the front. The value of shots that cannot be first is not computed.
void best_first(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots);

/// Returns the value of the best shot so far; 0 where values do not rank shots, or where it scratches. It is computed
/// for the shot that seems best to first order. Where shots are moved, each call moves one more.
double value_in_hand(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Moves shots to their safest launches (safest.hpp): all where all are wanted, else those that may then be first. The
/// best of them comes to the front.
void move_best(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Orders shots by their values; those without a computed value come last.
void order_by_value(std::span<Shot> shots);

/// Adds margin and success: to every shot where all are wanted, else to the first. This is no part of the search, so
/// `budget` is one of its own.
void add_robustness(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning
