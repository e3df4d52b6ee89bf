// SPDX-License-Identifier: MIT
#include "bankshot/geometry/obstacle.hpp"

#include <cmath>

namespace bankshot {
namespace {

Vec2d direction_of(const Segment& s) { return (s.to - s.from) / norm(s.to - s.from); }

/// The corner between two segments along u and v, where the outline turns to the right.
Bend corner(const Segment& before, const Segment& after, const Vec2d& u, const Vec2d& v, int vertex) {
  // Both lie along the bisector: their lengths are 2 cos and 2 sin of half the turn, so never both small.
  const Vec2d of_normals = perpendicular(u) + perpendicular(v), of_sides = u - v, sum = of_normals + of_sides;
  return {.centre = after.from,
          .radius = 0,
          .middle = sum / norm(sum),
          .half = std::atan2(norm(of_sides), norm(of_normals)),
          .contact = Contact::vertex(vertex),
          .before = before.contact,
          .after = after.contact};
}

}  // namespace

Obstacles obstacles(const Table& table) {
  Obstacles out;
  const std::size_t n = table.vertices.size();
  out.segments.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
    out.segments.push_back({table.vertices[i], table.vertices[(i + 1) % n], Contact::rail(static_cast<int>(i))});
  Vec2d u = direction_of(out.segments.back());
  for (std::size_t i = 0; i < n; ++i) {
    const Segment &before = out.segments[(i + n - 1) % n], &after = out.segments[i];
    const Vec2d v = direction_of(after);
    if (cross(u, v) < 0) out.bends.push_back(corner(before, after, u, v, static_cast<int>(i)));
    u = v;
  }
  return out;
}

}  // namespace bankshot
