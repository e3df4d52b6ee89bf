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

/// Moves a launch to the arrival speed asked, by secants of the squared speeds. `turn`: the change of the aim [rad] per
/// ln speed. None where the launch is not made, there or on the way. Cost: one simulation a step.
std::optional<AsAsked> made_as_asked(const SearchRequest& request, EvaluationBudget& budget, Launch at,
                                     double turn = 0);

}  // namespace bankshot::planning
