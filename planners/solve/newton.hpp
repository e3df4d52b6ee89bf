// SPDX-License-Identifier: MIT
//
// Newton's method on the locked path: the one root finder of every step. Steps are cut to the longest of each unknown.
// Steps that do not come nearer are halved, since the derivatives may jump.
// Cost: about five simulations from an image. Guarantee: none; what it finds is verified by a replay.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "planners/settings.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// Called after each step with the new launch, the length of the step in longest steps, and the residuals that gave it.
/// Returns true to give up.
using Known = std::function<bool(const Launch&, double size, const Linear&)>;

/// Returns the root that Newton's method reaches inside a neighbourhood of its start. None where it leaves that, comes
/// no nearer, finds no step or no path to the last leg, or where `known` gives up.
std::optional<Launch> newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Neighbourhood& near,
                             const Known& known = {});

/// A change of each unknown.
using Step = std::array<double, most_unknowns>;

/// Returns the step to the root of the linear system; none where it is singular.
std::optional<Step> newton_step(const Linear& l, bool one_unknown);

/// Returns the size of a step in longest steps; infinite where a component is not finite.
double size_of(const Step& step, const Neighbourhood& near);

}  // namespace bankshot::planning
