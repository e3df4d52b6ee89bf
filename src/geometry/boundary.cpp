// SPDX-License-Identifier: MIT
#include "bankshot/geometry/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {
namespace {

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d d = b - a;
  const double length2 = dot(d, d);
  const double s = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + d * s));
}

/// The edge from `b` to `a` lies to the right of p, at its height: a polygon has p inside when an odd
/// number of edges do.
bool passes_right_of(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
}

/// Where a ball touches both cushions of a convex vertex.
Vec2d corner_of_centres(const Wall& a, const Wall& b) {
  const double det = cross(a.normal, b.normal);
  return {(a.offset * b.normal.y - b.offset * a.normal.y) / det, (b.offset * a.normal.x - a.offset * b.normal.x) / det};
}

Vec2d vertex_of(const Wall& w, double radius, double s) { return w.along * s + w.normal * (w.offset - radius); }

}  // namespace

Boundary::Boundary(const Table& table, double ball_radius)
    : radius(ball_radius), diagonal(table.diagonal()), extent(diagonal) {
  for (const Vec2d& v : table.vertices) extent = std::max({extent, std::abs(v.x), std::abs(v.y)});
  touch = std::max(tolerance::touch * diagonal, tolerance::coordinate * extent);
  const std::size_t n = table.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d a = table.vertices[i], b = table.vertices[(i + 1) % n];
    const Vec2d along = (b - a) / norm(b - a), normal = perpendicular(along);
    walls.push_back({normal, dot(normal, a) + radius, along, dot(along, a), dot(along, b), a + normal * radius,
                     b + normal * radius, Contact::rail(static_cast<int>(i))});
  }
  for (std::size_t i = 0; i < n; ++i) {
    Wall &before = walls[(i + n - 1) % n], &after = walls[i];
    const double turn = cross(before.along, after.along);
    if (turn > 0) {
      before.to = after.from = corner_of_centres(before, after);
      continue;
    }
    strictly_convex = false;
    if (turn < 0 && radius > 0) tips.push_back({table.vertices[i], radius, Contact::vertex(static_cast<int>(i))});
  }
  for (std::size_t i = 0; i < table.pockets.size(); ++i) {
    const Pocket& p = table.pockets[i];
    const double r = p.radius > 0 ? p.radius : tolerance::point_pocket * diagonal;
    pockets.push_back({p.at, r, Contact::pocket(static_cast<int>(i))});
  }
}

double Boundary::clearance(const Vec2d& at) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  Vec2d before = vertex_of(walls.back(), radius, walls.back().begin);
  for (const Wall& w : walls) {
    const Vec2d vertex = vertex_of(w, radius, w.begin);
    nearest = std::min(nearest, distance_to_segment(at, vertex, vertex_of(w, radius, w.end)));
    inside = inside != passes_right_of(vertex, before, at);
    before = vertex;
  }
  return (inside ? nearest : -nearest) - radius;
}

double Boundary::distance_to_centres(const Vec2d& point) const {
  if (clearance(point) >= 0) return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& w : walls)
    if (dot(w.to - w.from, w.along) >= 0) nearest = std::min(nearest, distance_to_segment(point, w.from, w.to));
  for (const Circle& c : tips) nearest = std::min(nearest, std::abs(norm(point - c.centre) - c.radius));
  return nearest;
}

}  // namespace bankshot
