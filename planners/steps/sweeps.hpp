// SPDX-License-Identifier: MIT
//
// What is left to try where seeds of a chain lead to no shot; for the step of chains.
#pragma once

#include <vector>

#include "planners/steps/leg.hpp"

namespace bankshot::planning::steps {

/// Each route of the cue ball with each of these legs, and those of images.
void sweeps(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Objects::Chain& chain,
            const std::vector<Leg>& known, Parts& parts);

/// Nothing more may be tried, or need be.
bool sweeps_over(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found);

}  // namespace bankshot::planning::steps
