// SPDX-License-Identifier: MIT
//
// Levenberg–Marquardt on the locked path (ceres::TinySolver): slower than newton.hpp, and converges from farther away.
// Cost: about ten locked simulations.
#pragma once

#include <optional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// Moves a launch near a root onto it; none where that does not converge.
std::optional<Launch> solve_locked(const Branch& aim, EvaluationBudget& budget, const Launch& seed);

/// Returns the root nearest in aim to the seed, over all aim points.
std::optional<Launch> refine(const SearchRequest& request, EvaluationBudget& budget, const Launch& seed,
                             const Route& route);

}  // namespace bankshot::planning
