// SPDX-License-Identifier: MIT
//
// Planner `ceres`: Levenberg–Marquardt (ceres::TinySolver) on dual-number derivatives of the locked residual, in (aim,
// ln speed) or in the aim alone.
// Seeds: the images of unfold.hpp with their routes; on tables with reflex vertices also a fan of aims with the routes
// their traces meet. Cost: about ten locked simulations a seed. Guarantee: none beyond verification; it finds the root
// its seed leads to.
#include "bankshot/geometry/aim_point.hpp"
#include "planners/methods/methods.hpp"
#include "planners/propose/refine.hpp"
#include "planners/solve/levenberg_marquardt.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

constexpr std::string_view word = "ceres";

/// Refines a fan of aims around the circle, for roots that have no image.
void from_fan(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const RootFinder& find) {
  constexpr int aims = settings::sweep::fan;
  for (int i = 0; i < aims; ++i)
    for (int n = request.cushions().min; n <= request.cushions().max; ++n) {
      if (stop::enough_seeds(request, budget, found)) return;
      const double angle = radians(360.0 / aims) * i;
      const Trace path = trace(request, budget, angle, Goal::exactly(request, n));
      const Route route = request.route ? *request.route : route_by(path.replay.path.cushions);
      if (static_cast<int>(route.size()) != n) continue;
      for (const AimPoint& aim_point : request.problem->aim_points)
        refine_aim({request, route, aim_point}, budget, found, angle, request.problem->boundary.diagonal, word, find);
    }
}

}  // namespace

void ceres(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const RootFinder find = [&](const Branch& aim, const Launch& seed) { return solve_locked(aim, budget, seed); };
  refine_images(request, budget, found, word, find);
  if (!request.problem->boundary.unfolds()) from_fan(request, budget, found, find);
}

}  // namespace bankshot::planning::methods
