// SPDX-License-Identifier: MIT
#include "bankshot/scene/leave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/geometry/obstacle.hpp"

namespace bankshot {

// A ray from the point towards +x crosses the edges of a polygon an odd number of times if the point lies inside.
double distance_to(const LeaveRegion& region, const Vec2d& at) {
  const std::vector<Vec2d>& corners = region.vertices;
  bool inside = false;
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vec2d &a = corners[i], &b = corners[j], edge = b - a;
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + edge.x * (at.y - a.y) / edge.y) inside = !inside;
    square = std::min(square, square_to_segment(at, a, b));
  }
  return inside ? 0 : std::sqrt(square);
}

double miss_of(const Leave& leave, const Vec2d& at) {
  if (const auto* place = std::get_if<LeavePlace>(&leave)) return norm(at - place->at);
  if (const auto* region = std::get_if<LeaveRegion>(&leave)) return distance_to(*region, at);
  return 0;
}

}  // namespace bankshot
