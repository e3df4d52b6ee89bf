// SPDX-License-Identifier: MIT
//
// The steps of `auto` (docs/architecture.md lists them). methods/auto.cpp decides when each runs. A step reads the
// request, charges the budget, and adds to the search result.
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
/// All aims and speeds, in cells of this size.
void partition(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing);
void along(const SearchRequest& request, EvaluationBudget& budget,
           SearchResult& found);  ///< exactly along a cushion that the ball touches
void jaw_shots(const SearchRequest& request, EvaluationBudget& budget,
               SearchResult& found);                                                       ///< by the jaws of a pocket
void chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);  ///< another ball is sent on
/// The same for one arrival speed after the other: of each chain the ways of its last ball, by itself, that need no
/// other look.
using KnownLegs = std::map<const Objects::Chain*, std::vector<Candidate>>;
void chains_again(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, KnownLegs& known);
void caroms(const SearchRequest& request, EvaluationBudget& budget,
            SearchResult& found);  ///< off one ball onto another, followed forwards

/// Cells fine enough that the map leaves nothing out where every shot is wanted.
Spacing usual_spacing(const SearchRequest& request);

/// Launches so near each other lead to one root (settings::alike).
bool alike(const Launch& a, const Launch& b);

/// Where what one aims at is blocked, some part of the target may be reached beside it: from each lead to where it has
/// most room; with other balls then rows of aims around those that lack little. Until one is a shot.
void partial_targets(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

/// Chains, and caroms at more launch speeds, followed forwards: ten times the cost of `chains`.
void contact_windows(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning::propose
