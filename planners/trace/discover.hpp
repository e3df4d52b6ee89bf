// SPDX-License-Identifier: MIT
//
// `discover` follows the real path of a launch with derivatives. It returns the branch, and how the path would miss
// each aim point if it ended after any number of meetings that the puzzle allows: one path serves all targets. Other
// balls block paths and make none, so it looks through them. A path that comes off jaws ends there, unless it is
// followed through them: then their contacts are meetings of its branch. Cost: one simulation with dual numbers.
#pragma once

#include <span>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

struct Passage {
  std::size_t meetings, aim_point;  ///< how many of the route's, and which of the aim points
  Linear linear;
  Vec2d along;  ///< unit, of the line of travel there
};

/// The place of a bounce along its cushion [m], and how it changes with the aim [m/rad]; zeros for a vertex.
struct BouncePlace {
  double along = 0, by_aim = 0;
};

struct Discovery {
  Route route;                      ///< the branch, as far as it may be asked for
  std::vector<BouncePlace> places;  ///< of the real path's meetings
  std::vector<Passage> passages;
  bool rests = false;  ///< the path ends by itself before all the bounces asked
};

/// `locked`: a route that is given is traced instead.
void discover(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, bool locked,
              Discovery& out);

/// Goes on through jaws, past those of these mouths into which an aim so near [rad] may lead, after any bounces that
/// what is asked for may begin with.
void discover_through_jaws(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, double near,
                           std::span<const AimPoint> mouths, Discovery& out);

}  // namespace bankshot::planning
