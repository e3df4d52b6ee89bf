// SPDX-License-Identifier: MIT
//
// Newton's method on the locked path: the one root finder of every step. Steps are cut to the longest of each unknown.
// Steps that do not come nearer are halved, since the derivatives may jump.
// Cost: about five simulations from an image. Guarantee: none; what it finds is verified by a replay.
#pragma once

#include <functional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

enum class NewtonStatus {
  converged,
  left,      ///< too far from where it started
  astray,    ///< too many steps came no nearer
  singular,  ///< no step exists, or the path never gets to its last leg
  known      ///< the caller knows the root to which it goes
};

struct NewtonResult {
  Launch launch{};
  NewtonStatus status = NewtonStatus::singular;
  int iterations = 0;
  explicit operator bool() const { return status == NewtonStatus::converged; }
};

/// Called after each step with the new launch, the length of the step in longest steps, and the residuals that gave it.
/// Returns true to give up.
using Known = std::function<bool(const Launch&, double size, const Linear&)>;

NewtonResult newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Unknowns& unknowns,
                    const Known& known = {});

/// Runs Newton's method inside a neighbourhood of its start.
inline NewtonResult newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Neighbourhood& near,
                           const Known& known = {}) {
  return newton(aim, budget, from, unknowns_of(aim.request, near), known);
}

/// A change of each unknown.
using Step = std::array<double, most_unknowns>;

/// Returns the step to the root of the linear system; none where it is singular.
std::optional<Step> newton_step(const Linear& l, bool one_unknown);

}  // namespace bankshot::planning
