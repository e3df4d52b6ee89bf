// SPDX-License-Identifier: MIT
//
// Newton's method on the locked path: the one root finder of every step.
// Steps are cut to the longest of each unknown; where the derivatives jump, those that do not come nearer are halved.
// Cost: about five simulations from an image. Guarantee: none; what it finds is proved by a replay.
#pragma once

#include <functional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

enum class NewtonStatus {
  converged,
  left,      ///< too far from where it started
  astray,    ///< too many steps came no nearer
  singular,  ///< no step exists, or the path never gets to its last leg
  known      ///< whoever asked knew where it leads
};

struct NewtonResult {
  Launch launch{};
  NewtonStatus status = NewtonStatus::singular;
  int iterations = 0;
  explicit operator bool() const { return status == NewtonStatus::converged; }
};

/// Asked after each step where it led, how long it was, in longest steps, and what it followed: true to give up.
using Known = std::function<bool(const Launch&, double size, const Linear&)>;

NewtonResult newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Unknowns& unknowns,
                    const Known& known = {});

/// The same inside a neighbourhood of where it starts.
inline NewtonResult newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Neighbourhood& near,
                           const Known& known = {}) {
  return newton(aim, budget, from, unknowns_of(aim.request, near), known);
}

/// A change of each unknown.
using Step = std::array<double, most_unknowns>;

/// To the root of the linear system; none where it is singular.
std::optional<Step> newton_step(const Linear& l, bool one_unknown);

}  // namespace bankshot::planning
