// SPDX-License-Identifier: MIT
//
// The only door out: a launch becomes a shot here and nowhere else, by a replay in the plain simulator.
// Properties:
//  1. Every bound of the puzzle holds of what is proved: launch speed, aim, bounces, cushions in order, pockets,
//  arrival
//     speed, and the budget: without anything left of it nothing is replayed.
//  2. It depends on the simulator alone. No planner, no derivative takes part.
//  3. The launch is the one that its answer prints: its degrees read back to the same number.
// Cost: one simulation.
#pragma once

#include "planners/proof/replay.hpp"

namespace bankshot::planning {

/// A shot, or why the launch is none; of a failure the shot's `launch`, `cushions`, `arrival` and `miss` are what the
/// replay saw.
struct Proof {
  Shot shot{};
  Failure failure{};
  bool replayed = false;  ///< a bound on the launch or the budget may have forbidden that
  bool holds() const { return failure.foul == Foul::none; }
};

Proof prove(const Question& q, Ledger& ledger, const Launch& proposed, const Goal& goal);

}  // namespace bankshot::planning
