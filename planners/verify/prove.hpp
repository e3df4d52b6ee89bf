// SPDX-License-Identifier: MIT
//
// Verification: a launch becomes a shot here and nowhere else, by a replay in the plain simulator.
// Properties:
//  1. Every bound of the puzzle holds for a verified shot: launch speed, aim, bounces, cushions in order, pockets, and
//     the budget: without any of it left nothing is replayed. So does the arrival speed, unless the goal demands only
//     `made`; a shot moved to its safest launch keeps it where the puzzle gives `arrive`.
//  2. It depends on the simulator alone. No planner and no derivative takes part.
//  3. The launch is the one that its answer prints: its degrees read back to the same number.
// Cost: one simulation.
#pragma once

#include "planners/verify/replay.hpp"

namespace bankshot::planning {

/// A shot, or the reason why the launch is none. After a failure the shot's `launch`, `cushions`, `arrival` and `miss`
/// are what the replay saw.
struct Proof {
  Shot shot{};
  Failure failure{};
  bool replayed = false;  ///< false if a bound on the launch, or the budget, forbade it
  bool holds() const { return failure.reason == FailureReason::none; }
};

Proof prove(const SearchRequest& request, EvaluationBudget& budget, const Launch& proposed, const Goal& goal);

}  // namespace bankshot::planning
