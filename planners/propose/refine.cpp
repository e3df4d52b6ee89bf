// SPDX-License-Identifier: MIT
#include "planners/propose/refine.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "planners/propose/unfold.hpp"
#include "planners/solve/speed.hpp"
#include "planners/stop.hpp"
#include "planners/verify/bounds.hpp"

namespace bankshot::planning {

bool refine_aim(const Branch& aim, EvaluationBudget& budget, SearchResult& found, double angle, double length,
                std::string_view step, const RootFinder& find) {
  const auto speed = speed_at(aim, budget, angle, length);
  if (!speed) return false;
  const auto root = find(aim, {*speed, angle});
  if (root) certify_root(aim, budget, found, *root, step);
  return root.has_value();
}

void refine_images(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, std::string_view step,
                   const RootFinder& find) {
  const bool straight = is_straight(request.puzzle().physics);
  // A route with a root at one aim point hardly ever has another there.
  std::set<std::pair<Route, std::size_t>> settled;
  for (const Candidate& candidate : found.candidates)
    if (request.starts())
      settled.insert({candidate.route,
                      static_cast<std::size_t>(std::ranges::find(request.problem->aim_points, candidate.aim_point) -
                                               request.problem->aim_points.begin())});
  for (const double share : settings::restitution_shares) {
    const double e = share * restitution(request.puzzle().physics).at_rest;
    Unfolding images(request, {.parts = !straight, .restitution = e, .keep_routes = true});
    while (const auto image = images.next()) {
      if (stop::enough_seeds(request, budget, found)) return;
      if (double aim = image->angle; request.starts() && !inside_aims(aim, request.angle)) continue;
      std::pair key{images.route(*image), image->aim_point};
      if (settled.contains(key)) continue;
      if (key.first.empty() && share != settings::restitution_shares.front()) continue;  // no cushion bends the path
      const Branch aim{request, key.first, request.problem->aim_points[image->aim_point]};
      if (refine_aim(aim, budget, found, image->angle, image->distance, step, find)) settled.insert(std::move(key));
    }
    if (straight || !images.whole()) return;
    if (request.route && !found.shots.empty()) return;
  }
}

}  // namespace bankshot::planning
