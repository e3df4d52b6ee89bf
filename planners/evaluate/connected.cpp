// SPDX-License-Identifier: MIT
#include "planners/evaluate/connected.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planners/evaluate/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {
namespace {

bool all_between(const SearchRequest& request, EvaluationBudget& budget, const Shot& a, const Shot& b) {
  constexpr int steps = settings::connected::steps;
  const double turn = angle_difference(a.launch.angle, b.launch.angle);
  const Goal goal = Goal::along(a);
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Launch launch{std::lerp(a.launch.speed, b.launch.speed, share), wrap_angle(a.launch.angle + share * turn)};
    if (!replay(request, budget, launch, goal).made) return false;
  }
  return true;
}

bool are_one(const SearchRequest& request, EvaluationBudget& budget, const Shot& a, const Shot& b) {
  if (a.spin != b.spin || route_of(a) != route_of(b) ||
      !(request.problem->aim_point_of(a) == request.problem->aim_point_of(b)) || budget.spent())
    return false;
  return as_struck(request, a, [&](const SearchRequest& own) { return all_between(own, budget, a, b); });
}

}  // namespace

void keep_connected_once(const SearchRequest& request, EvaluationBudget& budget, std::vector<Shot>& shots) {
  std::vector<Shot> kept;
  for (Shot& shot : shots)
    if (std::ranges::none_of(kept, [&](const Shot& other) { return are_one(request, budget, other, shot); }))
      kept.push_back(std::move(shot));
  shots = std::move(kept);
}

}  // namespace bankshot::planning
