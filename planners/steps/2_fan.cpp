// SPDX-License-Identifier: MIT
//
// A route that is given, on its locked path at the speeds that arrive as asked: aims outward from its image, first near
// it, then on either side up to half a turn away. Cost: some six simulations an aim. Guarantee: none.
#include <cmath>

#include "planners/images/unfold.hpp"
#include "planners/locked/speed.hpp"
#include "planners/settings.hpp"
#include "planners/steps/forward_map.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

void fan(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  const Spacing cell = settings::forward_map::usual;
  ForwardMap nodes(request, budget, found, cell, word::fan);
  const int most = static_cast<int>(std::ceil(radians(180) / cell.aim));
  Unfolding images(request,
                   {.parts = true, .restitution = restitution(request.puzzle().physics).at_rest, .keep_routes = true});
  bool more = !budget.spent();
  while (const auto image = images.next()) {
    const Route route = images.route(*image);
    const Branch aim{request, route, request.problem->aim_points[image->aim_point]};
    for (int i = 1; i <= 2 * most && more; ++i) {
      const double angle = image->angle + cell.aim * (i / 2) * (i % 2 == 0 ? 1 : -1);
      if (const auto speed = speed_at(aim, budget, angle, image->distance)) nodes.visit(angle, *speed);
      more = !nodes.done();
    }
  }
}

}  // namespace bankshot::planning::steps
