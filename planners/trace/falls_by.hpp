// SPDX-License-Identifier: MIT
//
// `falls_by` plays the last ball of a route on the real table, once the locked path has led it past its last meeting.
// Nothing else moves any more, and jaws and rails may turn it. Cost: one simulation of one ball. A replay of all balls
// costs much more, and decides.
#pragma once

#include <optional>
#include <vector>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// Returns the further cushions, in order, by which the ball falls into its aim point; none where it does not fall.
std::optional<std::vector<Contact>> falls_by(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

}  // namespace bankshot::planning
