// SPDX-License-Identifier: MIT
#include "bankshot/geometry/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {
namespace {

double distance_to_bend(const Vec2d& p, const Bend& b) {
  const Vec2d d = p - b.centre;
  if (dot(d, b.middle) >= norm(d) * std::cos(b.half)) return std::abs(norm(d) - b.radius);
  const Vec2d along = b.middle * std::cos(b.half), across = perpendicular(b.middle) * std::sin(b.half);
  return std::min(norm(d - (along + across) * b.radius), norm(d - (along - across) * b.radius));
}

/// Returns true if the edge from `b` to `a` passes to the right of p, at its height. A polygon contains p if an
/// odd number of edges do.
bool passes_right_of(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
}

/// Returns the centre of a ball that touches both cushions of a convex vertex.
Vec2d corner_of_centres(const Wall& a, const Wall& b) {
  const double det = cross(a.normal, b.normal);
  return {(a.offset * b.normal.y - b.offset * a.normal.y) / det, (b.offset * a.normal.x - a.offset * b.normal.x) / det};
}

/// Returns a segment moved by the radius, as the centre of a ball meets it.
Wall moved(const Segment& s, double radius) {
  const Vec2d along = (s.to - s.from) / norm(s.to - s.from), normal = perpendicular(along);
  return {.normal = normal,
          .offset = dot(normal, s.from) + radius,
          .along = along,
          .begin = dot(along, s.from),
          .end = dot(along, s.to),
          .from = s.from + normal * radius,
          .to = s.to + normal * radius,
          .contact = s.contact};
}

/// Returns a bend enlarged by the radius, as the centre of a ball meets it. Its arc grows to either side by half of
/// what it lacks to a half circle, 45° or more: at the ends, rounding must not decide between the bend and the wall
/// that touches it there. No ball reaches the added part, because its centre would be 0.7 R outside the table there.
/// Only a ball hardly larger than the touching tolerance could, so for it the circle is whole.
Circle moved(const Bend& b, double radius, double touch) {
  constexpr double hardly_larger = 16;
  Circle c{b.centre, b.radius + radius, b.contact, b.before, b.after};
  if (c.radius > hardly_larger * touch)
    c.middle = b.middle, c.least = -std::sin(b.half / 2), c.extent = std::cos(b.half);
  return c;
}

}  // namespace

Boundary::Boundary(const Table& table, const Body& of, std::span<const Ball> others, std::span<const int> except)
    : own(table.own), body(of), diagonal(table.diagonal()), extent(diagonal) {
  const double radius = body.radius;
  for (const Vec2d& v : table.vertices) extent = std::max({extent, std::abs(v.x), std::abs(v.y)});
  touch = std::max(tolerance::touch * diagonal, tolerance::coordinate * extent);
  Obstacles there = obstacles(table);
  walls.reserve(there.segments.size());
  pockets.reserve(table.pockets.size());
  for (const Segment& s : there.segments) walls.push_back(moved(s, radius));
  outline_ = table.vertices;
  segments_ = std::move(there.segments);
  if (!there.jaws.empty()) open(table, there.jaws);
  for (std::size_t i = 0, n = walls.size(); i < n; ++i) {
    Wall &before = walls[(i + n - 1) % n], &after = walls[i];
    if (cross(before.along, after.along) > 0)
      before.to = after.from = corner_of_centres(before, after);
    else
      strictly_convex = false;
  }
  for (const Bend& b : there.bends) {
    if (!(b.radius + radius > 0)) continue;  // two segments end there; a point ball needs no bend
    tips.push_back(moved(b, radius, touch));
    if (b.contact.kind == ContactKind::vertex) unfolds_ = false;  // other bends are at a pocket's mouth
  }
  for (std::size_t i = 0; i < table.pockets.size(); ++i) {
    const Pocket& p = table.pockets[i];
    const double r = p.radius > 0 ? p.radius : tolerance::point_pocket * diagonal;
    pockets.push_back({p.at, r, Contact::pocket(static_cast<int>(i))});
  }
  for (int k = 1; k <= static_cast<int>(others.size()); ++k) {
    const Ball& other = others[static_cast<std::size_t>(k) - 1];
    if (std::ranges::count(except, k) == 0)
      balls.push_back({other.at, touching_distance(body, other.body), Contact::ball(k)});
  }
}

/// Ends the rails at the tips of jaws and extends the inside of the table between the jaws.
void Boundary::open(const Table& table, const std::vector<JawPieces>& jaw_pieces) {
  outline_ = outline(table, jaw_pieces);
  std::vector<Segment> pieces;
  breaks_.resize(walls.size());
  for (std::size_t k = 0; k < jaw_pieces.size(); ++k) {
    const JawPieces& m = jaw_pieces[k];
    jaws.push_back({{moved(m.tips[0], body.radius, touch), moved(m.tips[1], body.radius, touch)}, {}, m.faced()});
    bends_.insert(bends_.end(), m.tips.begin(), m.tips.end());
    for (std::size_t i = 0; m.faced() && i < 2; ++i) {
      jaws.back().facings[i] = moved(m.facings[i], body.radius);
      pieces.push_back(m.facings[i]);
    }
    for (const Break& b : m.breaks) {
      const auto rail = static_cast<std::size_t>(b.rail);
      breaks_[rail].push_back({walls[rail].begin + b.begin, walls[rail].begin + b.end, static_cast<int>(k)});
    }
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& w = walls[i];
    std::vector<Breach>& breaks = breaks_[i];
    std::ranges::sort(breaks, {}, &Breach::begin);
    double from = w.begin;
    const auto add = [&](double to) {
      const Vec2d start = segments_[i].from - w.along * w.begin;
      if (to > from) pieces.push_back({start + w.along * from, start + w.along * to, w.contact});
    };
    for (Breach& b : breaks) {
      add(b.begin);
      from = b.end;
      // Beyond the end of a rail there is no cushion.
      if (b.begin <= w.begin) b.begin = -std::numeric_limits<double>::infinity();
      if (b.end >= w.end) b.end = std::numeric_limits<double>::infinity();
    }
    add(w.end);
  }
  segments_ = std::move(pieces);
}

const Wall* Boundary::facing(Contact jaw) const {
  const int piece = jaw.jaw_piece();
  if (piece == 0 || piece == 3) return nullptr;
  return &jaws[static_cast<std::size_t>(jaw.jaw_pocket())].facings[piece == 1 ? 0 : 1];
}

const Circle* Boundary::tip(Contact jaw) const {
  const int piece = jaw.jaw_piece();
  if (piece == 1 || piece == 2) return nullptr;
  return &jaws[static_cast<std::size_t>(jaw.jaw_pocket())].tips[piece == 0 ? 0 : 1];
}

double Boundary::clearance(const Vec2d& at) const {
  double square = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Segment& s : segments_) square = std::min(square, square_to_segment(at, s.from, s.to));
  double nearest = std::sqrt(square);
  for (const Bend& b : bends_)  // no part of a bend is nearer than its circle
    if (std::abs(norm(at - b.centre) - b.radius) < nearest) nearest = std::min(nearest, distance_to_bend(at, b));
  for (std::size_t i = 0, n = outline_.size(); i < n; ++i)
    inside = inside != passes_right_of(outline_[i + 1 < n ? i + 1 : 0], outline_[i], at);
  return (inside ? nearest : -nearest) - body.radius;
}

double Boundary::distance_to_centres(const Vec2d& point) const {
  if (clearance(point) >= 0) return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& w : walls)
    if (dot(w.to - w.from, w.along) >= 0)
      nearest = std::min(nearest, std::sqrt(square_to_segment(point, w.from, w.to)));
  for (const Circle& c : tips) nearest = std::min(nearest, std::abs(norm(point - c.centre) - c.radius));
  return nearest;
}

const Circle* Boundary::pocket_around(const Vec2d& at) const {
  const double point = tolerance::point_pocket * diagonal;
  const auto found = std::ranges::find_if(
      pockets, [&](const Circle& c) { return c.radius > point && norm(at - c.centre) < c.radius; });
  return found == pockets.end() ? nullptr : &*found;
}

Vec2d Boundary::moved_inside(Vec2d at, double most) const {
  const auto off_wall = [&](const Wall& w) {
    const double gap = dot(w.normal, at) - w.offset, along = dot(w.along, at);
    if (gap < 0 && gap > -most && along >= w.begin && along <= w.end) at -= w.normal * gap;
  };
  const auto off_tip = [&](const Circle& c) {
    const Vec2d out = at - c.centre;
    const double far = norm(out);
    if (far < c.radius && far > std::max(0.0, c.radius - most) && c.covers(at)) at = c.centre + out * (c.radius / far);
  };
  for (const Wall& w : walls)
    if (jaws.empty() || break_at(w, dot(w.along, at)) < 0) off_wall(w);
  std::ranges::for_each(tips, off_tip);
  for (const JawWalls& jaw : jaws) {
    std::ranges::for_each(jaw.tips, off_tip);
    if (jaw.faced) std::ranges::for_each(jaw.facings, off_wall);
  }
  return at;
}

}  // namespace bankshot
