// SPDX-License-Identifier: MIT
#include "planners/images/exact_lines.hpp"

#include <cmath>

#include "planners/settings.hpp"

namespace bankshot::planning {

ExactLines::ExactLines(const Mark& mark, const Affine& image, const Vec2d& from) {
  using namespace settings::exact_lines;
  const Opening& arc = mark.opening;
  if (!mark.captures() || arc.whole()) {
    points_[size_++] = mark.at;
    return;
  }
  const auto seen = [&](const Vec2d& point) {  // its direction as the ball travels there
    const Vec2d way = image.back(image.apply(mark.at + point) - from);
    return way / norm(way);
  };
  struct Line {
    Vec2d through;  ///< m from the centre
    double beside;  ///< m, on its left
  };
  const double eighth = arc.radius / 8;
  for (const Line& line : {Line{{}, 0}, Line{(arc.first + arc.last * 7) / 8, 0}, Line{(arc.first * 7 + arc.last) / 8, 0},
                           Line{arc.last * 7 / 8, eighth}, Line{arc.first * 7 / 8, -eighth}}) {
    Vec2d u = seen(line.through);
    for (int i = 0; line.beside != 0 && i < most_turns; ++i) {
      const Vec2d turned = seen(line.through + perpendicular(u) * line.beside);
      const double by = norm(turned - u);
      u = turned;
      if (by < settled) break;
    }
    const Vec2d point = line.through + perpendicular(u) * line.beside;
    const double offset = cross(u, point);
    if (std::abs(mark.exact_offset(u, offset) - offset) <= nearly * arc.radius) points_[size_++] = mark.at + point;
  }
  if (size_ == 0) points_[size_++] = mark.at;
}

}  // namespace bankshot::planning
