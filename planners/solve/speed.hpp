// SPDX-License-Identifier: MIT
//
// The launch speed at which a locked path at a given angle arrives as fast as asked.
#pragma once

#include <optional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// Returns the speed to some 2 %, for a path some `length` metres long. It uses bracketed secants in the square of the
/// speed; falling short counts as too slow. None where no speed gets there. Cost: about four locked simulations.
std::optional<double> speed_at(const Branch& aim, EvaluationBudget& budget, double angle, double length);

/// Returns the speed exactly, by Newton's method from a speed near it.
std::optional<double> speed_near(const Branch& aim, EvaluationBudget& budget, double angle, double guess);

}  // namespace bankshot::planning
