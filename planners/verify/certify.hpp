// SPDX-License-Identifier: MIT
//
// Keeps verified launches in the search result: each shot once, with its derivatives. Other launches are counted under
// their failure reasons.
#pragma once

#include <string_view>

#include "planners/trace/residual.hpp"
#include "planners/verify/prove.hpp"

namespace bankshot::planning {

/// Verifies a launch and keeps its shot; returns whether it is one. Of shots that differ only by bounces at the target
/// itself, the one with fewer is kept. `step` names the step that proposed it (docs/architecture.md).
bool certify(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Launch& launch,
             int bounces, std::string_view step, Demand demand = Demand::exact);

/// Returns whether two shots are one launch that arrives once.
bool same_shot(const SearchRequest& request, const Shot& known, const Shot& shot);

/// Keeps a verified shot, unless it is known.
void keep(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Shot shot, const Goal& goal,
          std::string_view step);

/// Verifies a root along a route likewise; a root that is no shot is kept as a candidate.
bool certify_root(const Branch& aim, EvaluationBudget& budget, SearchResult& found, const Launch& root,
                  std::string_view step);

/// See Verification::digits.
std::optional<int> promised_digits(const SearchRequest& request, const Shot& shot);

}  // namespace bankshot::planning
