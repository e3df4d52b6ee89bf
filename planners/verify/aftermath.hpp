// SPDX-License-Identifier: MIT
//
// The whole shot, with all balls, until every ball rests. A replay stops when the target is reached.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bankshot/simulate/route.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

/// Adds to a new shot whether the cue ball falls, and where it comes to rest. Does nothing for a shot that hits no
/// ball, or whose target is none. In `ideal`, where no ball rests, it tells only whether the cue ball falls within
/// `ideal_cushions` events. Cost: one simulation of all balls.
void add_aftermath(const SearchRequest& request, EvaluationBudget& budget, Shot& shot);

/// The places in which a shot leaves the balls, and the cue ball's route to its own.
struct Ending {
  /// m; of each ball, the cue ball first; none: it fell. Where the cue ball falls no place is known.
  std::vector<std::optional<Vec2d>> places{};
  Route cue{};                      ///< contacts of the cue ball, in order
  bool traceable = true;            ///< it met neither jaws nor a ball that had moved
  bool rail_after_contact = false;  ///< after the first contact a ball met a cushion, or fell
  std::size_t after_balls = 0;      ///< number of its meetings up to its last contact with a ball

  const std::optional<Vec2d>& cue_rests() const { return places.front(); }
};

/// Plays the shot until every ball rests, or the cue ball falls. Not for `ideal`, where no ball comes to rest, nor for
/// a target without a ball. Cost: one simulation of all balls.
Ending play_out(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch);

/// Returns the ending of a launch whose replay makes the target, without the cue ball's route. If only the cue ball
/// still moves when the replay ends, the simulation goes on from there. Cost: a simulation of all balls, or of what is
/// left of one.
Ending ending_of(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Replay& made);

/// Returns the places of all balls after one more shot, from places in which they rest; none: the ball fell, then or
/// before. Where the cue ball falls no place is known. Cost: one simulation of the balls that are left.
std::vector<std::optional<Vec2d>> play_on(const SearchRequest& request, EvaluationBudget& budget,
                                          std::span<const std::optional<Vec2d>> places, const Launch& launch,
                                          const LaunchSpin& spin);

}  // namespace bankshot::planning
