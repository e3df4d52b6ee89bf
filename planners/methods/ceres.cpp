// SPDX-License-Identifier: MIT
//
// Planner `ceres`: Levenberg–Marquardt (ceres::TinySolver) on dual-number derivatives of the
// locked residual, in (aim, ln speed) or in the aim alone.
// Seeds: the images of unfold.hpp with their routes; on tables with reflex vertices also a fan of
// aims with the routes their traces meet. Cost: about ten locked simulations a seed. Guarantee: none beyond the
// proof; it finds the root its seed leads to.
#include "planners/images/refine.hpp"
#include "planners/locked/levenberg_marquardt.hpp"
#include "planners/methods/methods.hpp"
#include "planners/stop.hpp"

namespace bankshot::planning::methods {
namespace {

constexpr std::string_view word = "ceres";

/// Every half degree, where no image exists.
void from_fan(const Question& q, EvaluationBudget& budget, SearchResult& found, const RootFinder& find) {
  constexpr int aims = settings::ceres::aims_in_fan;
  for (int i = 0; i < aims; ++i)
    for (int n = q.cushions().min; n <= q.cushions().max; ++n) {
      if (stop::enough_seeds(q, budget, found)) return;
      const double angle = radians(360.0 / aims) * i;
      std::vector<Contact> contacts;
      trace(q, budget, angle, Goal::exactly(q, n), &contacts);
      const Route route = q.route ? *q.route : route_by(contacts);
      if (static_cast<int>(route.size()) != n) continue;
      for (const AimPoint& aim_point : q.aim_points)
        refine_aim({q, route, aim_point}, budget, found, angle, q.boundary.diagonal, word, find);
    }
}

}  // namespace

void ceres(const Question& q, EvaluationBudget& budget, SearchResult& found) {
  const RootFinder find = [&](const LockedAim& aim, const Launch& seed) { return solve_locked(aim, budget, seed); };
  refine_images(q, budget, found, word, find);
  if (!q.boundary.unfolds()) from_fan(q, budget, found, find);
}

}  // namespace bankshot::planning::methods
