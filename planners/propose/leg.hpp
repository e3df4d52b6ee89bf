// SPDX-License-Identifier: MIT
//
// What the last ball that is sent on must do, as if it were launched by itself: a search of one ball.
#pragma once

#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/propose/proposers.hpp"

namespace bankshot::planning::propose {

struct Leg {
  Candidate alone;  ///< as found: the ball, which stands still, is the struck one
  Route route;      ///< the same, and its aim point, among all balls
  AimPoint aim_point;
  double spread = 0;  ///< m that it passes beside its aim point for a radian of its direction; 0: not known

  const Launch& launch() const { return alone.launch; }
};

/// By the roots that a step finds, but for those that are known. Where the launch speed of the cue ball is all that
/// is given, that of the other is guessed.
std::vector<Leg> legs(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain, Step starts,
                      std::vector<Candidate> known = {});

/// The only way to it is straight.
bool hit_straight(const SearchRequest& request, const Objects::Chain& chain);

/// The first ball is to be touched straight, and balls that stand before it hide all of it.
bool is_hidden(const SearchRequest& request, const Objects::Chain& chain);

/// The balls before the last come to it by this route.
Route together(const Objects::Chain& chain, Route before, const Leg& leg);

}  // namespace bankshot::planning::propose
