// SPDX-License-Identifier: MIT
//
// The launch speed at which a locked path at a given angle arrives as fast as asked.
#pragma once

#include <optional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// To some 2 %, of a path some `length` metres long: secants in the square of the speed, bracketed; falling short
/// counts as too slow. None where no speed gets there. About four locked simulations.
std::optional<double> speed_at(const Branch& aim, EvaluationBudget& budget, double angle, double length);

/// Exactly, by Newton's method from a speed near it.
std::optional<double> speed_near(const Branch& aim, EvaluationBudget& budget, double angle, double guess);

}  // namespace bankshot::planning
