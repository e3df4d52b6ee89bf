// SPDX-License-Identifier: MIT
#include "io/answer/sights.hpp"

#include <algorithm>

namespace bankshot {
namespace {

struct Edge {
  Vec2d from, to;
};

/// Returns the line `back` metres behind a cushion's nose, directed from the left or from the bottom.
Edge line_behind(const Table& t, std::size_t i, double back) {
  const Vec2d a = t.vertices[i], b = t.vertices[(i + 1) % t.vertices.size()];
  const Vec2d out = -perpendicular(b - a) * (back / norm(b - a));
  const bool reversed = t.is_rectangle() && (b.x < a.x || b.y < a.y);
  return reversed ? Edge{b + out, a + out} : Edge{a + out, b + out};
}

}  // namespace

double sight_distance(const Table& t) {
  constexpr double wpa = 0.0936625, most = 0.05;  // relative to the longer side; more than on any table that is sold
  const Vec2d size = t.highest() - t.lowest();
  return std::min(wpa, most * std::max(size.x, size.y));
}

int diamonds_along(const Table& t, int cushion) {
  const Edge e = line_behind(t, static_cast<std::size_t>(cushion), 0);
  const Vec2d size = t.highest() - t.lowest();
  return norm(e.to - e.from) >= std::max(size.x, size.y) ? 8 : 4;
}

std::optional<Sight> sight(const Table& t, const Vec2d& from, const Vec2d& aim) {
  const double back = t.is_rectangle() ? sight_distance(t) : 0;
  std::optional<Sight> nearest;
  double least = 0;
  for (std::size_t i = 0; i < t.vertices.size(); ++i) {
    const Edge e = line_behind(t, i, back);
    const Vec2d along = e.to - e.from;
    const double way = cross(e.from - from, along) / cross(aim, along),
                 part = cross(e.from - from, aim) / cross(aim, along);
    const double beyond = back / norm(along);  // lines of diamonds extend to behind the corner
    if (!(way > 0 && part >= -beyond && part <= 1 + beyond) || (nearest && way >= least)) continue;
    const int cushion = static_cast<int>(i);
    nearest = Sight{cushion, from + aim * way, part, t.is_rectangle() ? part * diamonds_along(t, cushion) : 0};
    least = way;
  }
  return nearest;
}

}  // namespace bankshot
