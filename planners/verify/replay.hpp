// SPDX-License-Identifier: MIT
//
// The simulation of a launch against a goal. Cost: one simulation, which counts against the budget.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bankshot/motion/arc.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_result.hpp"
#include "planners/verify/goal.hpp"

namespace bankshot::planning {

struct Replay {
  bool made = false;  ///< in the contract's sense: within reach, after the bounces asked
  double miss = std::numeric_limits<double>::infinity();  ///< m, see Verification::miss
  double offset = 0;                                      ///< m, see Verification::offset
  ShotPath path{};                                        ///< up to the target, or to the failure
  Failure failure;                                        ///< if it is not made
  /// The cue ball when the target is made, if the only ball that it set going has fallen then.
  std::optional<State<double>> cue{};
  Work work{};

  int bounces() const { return static_cast<int>(path.cushions.size()); }
};

/// Replays a launch up to its target.
Replay replay_to_target(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Goal& goal);

/// Replays a launch. If the goal counts as `success` does, the cue ball is followed to the end, and may not fall.
Replay replay(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Goal& goal);

/// The speed that a path costs, if its shape does not depend on the speed: after the arcs added so far, v² = gain·v0² −
/// loss. The arcs are those of a launch at unit speed without friction.
class SpeedAccount {
 public:
  explicit SpeedAccount(double deceleration) : deceleration_(deceleration) {}
  void add(const Arc<double>& arc, double t);
  double gain = 1, loss = 0;  ///< –, m²/s²
  /// Returns whether no launch at `speed` or slower gets here.
  bool beyond(double speed) const { return loss > gain * speed * speed; }

 private:
  double deceleration_;  ///< m/s²
  double before2_ = 1;   ///< speed² on the arc before
};

/// The shape of a path, simulated at unit speed without friction (`ideal`, `rolling`).
struct Trace {
  Replay replay;
  SpeedAccount account;
};
Trace trace(const SearchRequest& request, EvaluationBudget& budget, double angle, const Goal& goal);

}  // namespace bankshot::planning
