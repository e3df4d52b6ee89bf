// SPDX-License-Identifier: MIT
//
// The real path of a launch, and how it would miss each aim point if its bounces ended after any number of them that
// the puzzle allows: what one node of a map sees. Cost: one simulation with dual numbers. A path that comes off jaws
// ends there, unless it is asked for: then their contacts are meetings of its route.
#pragma once

#include <span>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/locked/residual.hpp"

namespace bankshot::planning {

struct Passage {
  std::size_t meetings, aim_point;  ///< how many of the route's, and which of the aim points
  Linear linear;
  Vec2d along;  ///< unit, of the line of travel there
};

/// Where a bounce lies along its cushion [m], and how that changes with the aim [m/rad]; of a vertex nothing.
struct BouncePlace {
  double along = 0, by_aim = 0;
};

struct Forward {
  Route route;
  std::vector<BouncePlace> places;  ///< of the real path's meetings
  std::vector<Passage> passages;
  bool rests = false;  ///< the path ends by itself before all the bounces asked
};

/// `locked`: a route that is given is followed on its locked path.
void forward(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, bool locked, Forward& out);

/// On through jaws, past those of these mouths into which an aim so near [rad] may lead, after any bounces that what is
/// asked for may begin with.
void forward_through_jaws(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, double near,
                          std::span<const AimPoint> mouths, Forward& out);

}  // namespace bankshot::planning
