// SPDX-License-Identifier: MIT
//
// The leg of the last object ball, as if it were launched by itself: a search of one ball.
#pragma once

#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning::propose {

struct Leg {
  Candidate alone;  ///< as found, with this ball in the place of the cue ball
  Route route;      ///< the route and the aim point, numbered among all balls
  AimPoint aim_point;
  double spread = 0;  ///< m/rad; how far its offset at the aim point moves with its direction; 0: not known

  const Launch& launch() const { return alone.launch; }
};

/// Returns the legs by the roots to which stretched images lead, without those that are known. If only the launch speed
/// of the cue ball is given, that of the object ball is guessed.
std::vector<Leg> legs(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain,
                      std::vector<Candidate> known = {});

/// Returns whether the cue ball can reach the object ball by a straight line only.
bool hit_straight(const SearchRequest& request, const Objects::Chain& chain);

/// Returns whether the first ball is to be touched straight, and balls that stand before it hide all of it.
bool is_hidden(const SearchRequest& request, const Objects::Chain& chain);

/// Returns the whole route. `before`: the route of the balls before the last, up to it.
Route together(const Objects::Chain& chain, Route before, const Leg& leg);

}  // namespace bankshot::planning::propose
