// SPDX-License-Identifier: MIT
//
// Launches that are made by whatever they meet, brought to the arrival speed that is asked.
#pragma once

#include <optional>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

struct AsAsked {
  Launch launch;
  Replay replay;
};

/// From a launch on, at its aim or turned by so many rad per ln speed: by secants of the squared speeds. None where it
/// is not made, there or on the way. A simulation a step.
std::optional<AsAsked> made_as_asked(const SearchRequest& request, EvaluationBudget& budget, Launch at,
                                     double turn = 0);

}  // namespace bankshot::planning
