// SPDX-License-Identifier: MIT
#include "planners/propose/exact_line.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>

#include "planners/settings.hpp"

namespace bankshot::planning {

Vec2d on_exact_line(const AimPoint& aim_point, const Affine& image, const Vec2d& from) {
  if (!aim_point.captures()) return aim_point.at;
  // Seen on the table, all rays from the ball come from one place.
  const Vec2d way = image.back(image.apply(aim_point.at) - from), middle = way / norm(way);
  const double distance = norm(way) / std::abs(image.xx * image.yy - image.xy * image.yx);
  Vec2d u = middle;
  double offset = 0;
  for (int i = 0; i < settings::most_steps; ++i) {
    const double exact = aim_point.exact_offset(u, offset);
    const bool same = std::abs(exact - offset) <= settings::rounding * aim_point.reach;
    offset = exact;
    if (same) break;
    const double sine = std::clamp(offset / distance, -1.0, 1.0);
    u = middle * std::sqrt(1 - sine * sine) + perpendicular(middle) * sine;
  }
  return aim_point.at + perpendicular(u) * offset;
}

}  // namespace bankshot::planning
