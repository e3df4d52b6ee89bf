// SPDX-License-Identifier: MIT
//
// The steps of `auto` (docs/architecture.md lists them). methods/auto.cpp decides when each runs. A step reads the
// request, spends the budget, and adds to the search result.
#pragma once

#include <map>
#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning::propose {

using Proposer = void (*)(const SearchRequest&, EvaluationBudget&, SearchResult&);

void stretched_images(const SearchRequest& request, EvaluationBudget& budget,
                      SearchResult& found);  ///< stretched images, refined on the locked path
/// Searches all aims and speeds, in cells of this size.
void partition(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing);
void along(const SearchRequest& request, EvaluationBudget& budget,
           SearchResult& found);  ///< exactly along a cushion that the ball touches
void jaw_shots(const SearchRequest& request, EvaluationBudget& budget,
               SearchResult& found);  ///< by the jaws of a pocket
/// The launches of each chain's last ball, by itself, that need no other search.
using KnownLegs = std::map<const Objects::Chain*, std::vector<Candidate>>;
/// Sets object balls going. It runs for one arrival speed after the other. It skips legs that are known, and adds
/// those that no other speed needs.
void chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, KnownLegs& known);
void caroms(const SearchRequest& request, EvaluationBudget& budget,
            SearchResult& found);  ///< off one ball onto another, followed forwards

/// Returns the cells of a partition. Where every shot is wanted they are so fine that nothing is left out.
Spacing usual_spacing(const SearchRequest& request);

/// Returns whether two launches are so near each other that they lead to one root (settings::alike).
bool alike(const Launch& a, const Launch& b);

/// Searches for partial targets where the exact line is blocked. It goes from each candidate to the largest clearance.
/// With object balls it then bisects aims around candidates with a clearance little below 0. It stops at the first
/// shot.
void partial_targets(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Follows chains forwards, and caroms at more launch speeds. It costs ten times as much as `chains`.
void contact_windows(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning::propose
