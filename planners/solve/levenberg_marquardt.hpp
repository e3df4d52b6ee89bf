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

}  // namespace bankshot::planning
