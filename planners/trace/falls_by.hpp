// SPDX-License-Identifier: MIT
//
// How the last ball of a route falls as on the real table once the locked path has led it past its last meeting:
// nothing else moves any more, and jaws and rails may turn it. Cost: one simulation of one ball; a replay of all balls
// costs ten times as much and decides.
#pragma once

#include <optional>
#include <vector>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// The further cushions, in order, by which it falls into its aim point; none where it does not.
std::optional<std::vector<Contact>> falls_by(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

}  // namespace bankshot::planning
