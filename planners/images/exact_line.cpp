// SPDX-License-Identifier: MIT
#include "planners/images/exact_line.hpp"

#include <cmath>

#include "planners/settings.hpp"

namespace bankshot::planning {

Vec2d on_exact_line(const Mark& mark, const Affine& image, const Vec2d& from) {
  using namespace settings::exact_line;
  if (!mark.captures()) return mark.at;
  Vec2d at = mark.at;
  double offset = 0;
  for (int i = 0; i < most_turns; ++i) {
    const Vec2d way = image.back(image.apply(at) - from), u = way / norm(way);
    const double exact = mark.exact_offset(u, offset);
    const bool same = std::abs(exact - offset) <= settled * mark.reach;
    if (same && i > 0) break;
    offset = exact;
    at = mark.at + perpendicular(u) * exact;
    if (exact == 0) break;
  }
  return at;
}

}  // namespace bankshot::planning
