// SPDX-License-Identifier: MIT
#include "bankshot/scene/in_hand.hpp"

#include <algorithm>

namespace bankshot {

bool may_place(const Puzzle& p, const Boundary& boundary, const Vec2d& at) {
  const auto apart = [&](const Ball& ball) { return norm(at - ball.at) >= touching_distance(p.ball.body, ball.body); };
  return boundary.clearance(at) >= 0 && !boundary.pocket_around(at) && std::ranges::all_of(p.others, apart) &&
         (p.in_hand->where == InHand::Where::anywhere || distance_to(LeaveRegion{p.in_hand->vertices}, at) == 0);
}

std::vector<Vec2d> free_places(const Puzzle& p, double step) {
  const Boundary boundary(p.table, p.ball.body);
  const double radius = p.ball.body.radius;
  const Vec2d low = p.table.lowest() + Vec2d{radius, radius}, high = p.table.highest() - Vec2d{radius, radius};
  std::vector<Vec2d> places;
  for (double y = low.y; y <= high.y; y += step)
    for (double x = low.x; x <= high.x; x += step)
      if (may_place(p, boundary, {x, y})) places.push_back({x, y});
  return places;
}

Puzzle placed(Puzzle puzzle, const Vec2d& at) {
  puzzle.ball.at = at;
  puzzle.in_hand.reset();
  return puzzle;
}

}  // namespace bankshot
