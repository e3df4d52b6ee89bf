// SPDX-License-Identifier: MIT
//
// Takes the place of nlopt.cpp in a build without NLopt.
#include "planners/methods/nlopt.hpp"

namespace bankshot::planning::methods {

void search_box(const SearchRequest&, EvaluationBudget&, SearchResult&, std::string_view) {}

std::span<const Method> nlopt_methods() { return {}; }

}  // namespace bankshot::planning::methods
