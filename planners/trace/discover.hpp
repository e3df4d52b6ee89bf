// SPDX-License-Identifier: MIT
//
// `discover` follows the real path of a launch with derivatives. It returns the branch, and how the path would miss
// each aim point if it ended after any number of meetings that the puzzle allows. So one path serves all targets.
// Object balls block paths but never make one, so it looks through them. A path that comes off jaws ends there, unless
// it is followed through them; then their contacts are meetings of its branch.
// Cost: one simulation with dual numbers.
#pragma once

#include <span>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

struct Passage {
  std::size_t meetings, aim_point;  ///< number of meetings of the route before it, and index of the aim point
  Linear linear;
  Vec2d along;  ///< unit, of the line of travel there
};

/// The place of a bounce along its cushion [m], and how it changes with the aim [m/rad]; zeros for a vertex.
struct BouncePlace {
  double along = 0, by_aim = 0;
};

struct Discovery {
  Route route;                      ///< the route, as far as it may be asked for
  std::vector<BouncePlace> places;  ///< meetings of the real path
  std::vector<Passage> passages;
  bool rests = false;  ///< the path ends by itself before all the bounces asked
};

/// Follows the path of a launch. `locked`: if the request gives a route, that is traced instead.
void discover(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, bool locked,
              Discovery& out);

/// Follows a launch through jaws. Keeps the misses of those mouths into which an aim within `near` [rad] may lead. The
/// cushions on the path must begin the route that the puzzle asks for.
void discover_through_jaws(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, double near,
                           std::span<const AimPoint> mouths, Discovery& out);

}  // namespace bankshot::planning
