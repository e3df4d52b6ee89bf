// SPDX-License-Identifier: MIT
//
// The rules by which steps stop. A step asks before each thing it tries; some steps have rules of their own besides.
//   satisfied      a shot was found, and no other is wanted
//   over           nothing more may be tried: satisfied, or the budget is spent
//   enough_seeds   a step that proposes seed after seed may stop: there are shots enough to choose from
//   enough_images  a step that proposes exact images may stop. If they come shortest first, the first-order margin only
//                  falls with the length, so later ones are worse unless a bound or a pocket makes the difference
//   route_settled  one root of a given route is all there is to find, unless every shot is wanted
//   one_found      a step that is asked where nothing was found may stop at one shot
//   nothing_yet    there is no shot, and the budget is not spent: the next step of `auto` has its turn
#pragma once

#include <algorithm>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning::stop {

inline bool satisfied(const SearchRequest& request, const SearchResult& found) {
  return request.first() && !found.shots.empty();
}

inline bool over(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found) {
  return budget.spent() || satisfied(request, found);
}

inline bool enough_seeds(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const std::size_t enough = request.first() ? 1 : settings::enough_to_compare;
  const bool plenty = !request.all() && !request.starts() && found.shots.size() >= enough;
  found.plenty = found.plenty || plenty;
  return plenty || budget.spent();
}

inline bool enough_images(const SearchRequest& request, const SearchResult& found, bool shortest_first) {
  if (satisfied(request, found)) return true;
  if (request.all() || !shortest_first) return false;
  // Shots into a cushion that the ball touches come last.
  const auto counts = [&](const Shot& s) { return !request.problem->into_touched_cushion(s.launch.angle); };
  const auto seen = static_cast<std::size_t>(std::ranges::count_if(found.shots, counts));
  return seen >= (request.puzzle().prefer == Prefer::robust ? settings::enough_to_compare : 1);
}

inline bool route_settled(const SearchRequest& request, const SearchResult& found) {
  return request.route && !request.all() && !found.shots.empty();
}

inline bool nothing_yet(const EvaluationBudget& budget, const SearchResult& found) {
  return found.shots.empty() && !budget.cut();
}

/// Returns whether a step that is asked where nothing was found may stop: at one shot, unless every one is wanted.
inline bool one_found(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found) {
  return over(request, budget, found) || !(request.all() || request.starts() || found.shots.empty());
}

/// Returns whether a step that finds more shots, and not just one, has its turn.
inline bool more_wanted(const SearchRequest& request, const EvaluationBudget& budget, const SearchResult& found) {
  return (request.all() && !budget.cut()) || nothing_yet(budget, found);
}

}  // namespace bankshot::planning::stop
