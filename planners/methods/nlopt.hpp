// SPDX-License-Identifier: MIT
//
// The planners that use NLopt. A build without it has without_nlopt.cpp in place of nlopt.cpp: no planner, and a global
// search that finds nothing.
#pragma once

#include <span>
#include <string_view>

#include "planners/methods/methods.hpp"

namespace bankshot::planning::methods {

/// Runs the global search over the whole box of bounds (NLopt DIRECT-L), on the real path; `step` names it in answers.
void search_box(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, std::string_view step);

/// Returns the planners `nlopt-*`.
std::span<const Method> nlopt_methods();

}  // namespace bankshot::planning::methods
