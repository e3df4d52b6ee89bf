// SPDX-License-Identifier: MIT
//
// The aims that lead a chain on from ball to ball, at one launch speed after the other; for the steps of chains and
// caroms.
#pragma once

#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

/// All routes that occur, of a chain or off the first ball of a carom.
void bands(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Objects::Chain& chain);

}  // namespace bankshot::planning::steps
