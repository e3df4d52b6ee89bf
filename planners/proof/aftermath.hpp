// SPDX-License-Identifier: MIT
//
// The whole shot, with all balls, until every ball rests. A replay stops when the target is reached.
#pragma once

#include <optional>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

struct Aftermath {
  std::optional<int> scratch_pocket{};  ///< the pocket that the cue ball falls into
  std::optional<Vec2d> cue_rests{};     ///< m, where it comes to rest
};

/// Returns nothing for a shot whose target is no ball. In `ideal`, where no ball rests, it tells only whether the cue
/// ball falls within `ideal_cushions` events. Cost: one simulation of all balls.
Aftermath aftermath(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch);

/// Stores the aftermath in a shot.
void add_aftermath(const SearchRequest& request, EvaluationBudget& budget, Shot& shot);

}  // namespace bankshot::planning
