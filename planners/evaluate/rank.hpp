// SPDX-License-Identifier: MIT
//
// Which of the shots found is the answer: their order by `prefer`, and margin and success where they are asked for.
#pragma once

#include <span>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning {

/// How good a shot is by `prefer`, before its success is known; larger is better.
double first_merit(const Puzzle& puzzle, const Shot& shot);

/// Returns whether a shot comes before another one by `prefer`; the less likely to fall into a pocket comes first.
bool comes_before(const Puzzle& puzzle, const Shot& a, const Shot& b);

/// What success is at most of a shot to an aim point with this success estimate: a bound that settings::rank measures.
double success_at_most(const SearchRequest& request, const AimPoint& aim_point, double estimate);

/// Drops shots beside the exact line or point where others are on it, and orders the rest, best first.
void rank(const SearchRequest& request, std::vector<Shot>& shots);

/// Brings the shot with the largest value to the front; of shots that cannot be first it is not computed.
void best_first(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots);

/// The value of the best shot so far: of the one that seems best by first order, which knows of no scratch, it is
/// computed, once. 0 where values do not rank shots.
double value_in_hand(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Moves shots to their safest launches (safest.hpp): all where all are wanted, else those that may be first then, and
/// brings that one to the front.
void move_best(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Shots without a computed value come last.
void order_by_value(std::span<Shot> shots);

/// Margin and success: of every shot where all are wanted, else of the first. What that costs is no part of the search:
/// `budget` is one of its own.
void add_robustness(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning
