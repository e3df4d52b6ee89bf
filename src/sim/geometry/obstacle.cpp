// SPDX-License-Identifier: MIT
#include "bankshot/geometry/obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bankshot/scene/ball.hpp"

namespace bankshot {
namespace {

Vec2d direction_of(const Segment& s) { return (s.to - s.from) / norm(s.to - s.from); }

/// Returns the bend at the corner between two segments along u and v, where the outline turns right.
Bend corner(const Segment& before, const Segment& after, const Vec2d& u, const Vec2d& v, int vertex) {
  // Both vectors lie along the bisector. Their lengths are 2 cos and 2 sin of half the turn, so never both small.
  const Vec2d of_normals = perpendicular(u) + perpendicular(v), of_sides = u - v, sum = of_normals + of_sides;
  return {.centre = after.from,
          .radius = 0,
          .middle = sum / norm(sum),
          .half = std::atan2(norm(of_sides), norm(of_normals)),
          .contact = Contact::vertex(vertex),
          .before = before.contact,
          .after = after.contact};
}

/// The end of a rail at a pocket. The point `from` is the corner or the middle of the mouth; `a` points along the rail
/// away from it and `n` into the table. Without a tip, the rail would begin at distance `half`.
struct RailEnd {
  double seam;  ///< m from `from` to the start of the rail
  Bend tip;
  Segment facing;  ///< from the tip into the pocket
};
RailEnd rail_end(const Jaws& jaws, const Vec2d& from, const Vec2d& a, const Vec2d& n, double half) {
  const double turn = jaws.angle - radians(90), d = jaws.tip / std::tan(jaws.angle / 2);
  const double along = std::sin(turn), across = std::cos(turn);
  const Vec2d inwards = -a * along - n * across, facing = n * along - a * across, edge = from + a * half;
  const Vec2d near = edge + inwards * d, far = edge + inwards * (jaws.depth / across), middle = n + facing;
  RailEnd out{};
  out.seam = half + d;
  out.tip = {.centre = from + a * (half + d) - n * jaws.tip,
             .radius = jaws.tip,
             .middle = middle / norm(middle),
             .half = (radians(180) - jaws.angle) / 2};
  out.facing = {near, jaws.depth / across > d ? far : near};
  return out;
}

JawPieces jaw_pieces(const Table& table, int pocket) {
  const Jaws& jaws = *table.pockets[static_cast<std::size_t>(pocket)].jaws;
  const int n = static_cast<int>(table.vertices.size());
  const auto corner = std::find(table.vertices.begin(), table.vertices.end(), jaws.at) - table.vertices.begin();
  const bool at_corner = corner < n;
  const auto vertex = [&](int i) { return table.vertices[static_cast<std::size_t>((i + n) % n)]; };
  const auto along = [&](int rail) {
    return (vertex(rail + 1) - vertex(rail)) / norm(vertex(rail + 1) - vertex(rail));
  };
  int after = static_cast<int>(corner);
  if (!at_corner) {
    const auto off = [&](int rail) { return std::abs(cross(along(rail), jaws.at - vertex(rail))); };
    after = 0;
    for (int rail = 1; rail < n; ++rail)
      if (off(rail) < off(after)) after = rail;
  }
  const int before = at_corner ? (after + n - 1) % n : after;
  const double half = at_corner ? jaws.mouth / std::sqrt(2.0) : jaws.mouth / 2;
  const RailEnd ends[] = {rail_end(jaws, jaws.at, -along(before), perpendicular(along(before)), half),
                          rail_end(jaws, jaws.at, along(after), perpendicular(along(after)), half)};
  JawPieces out;
  const double length = norm(vertex(before + 1) - vertex(before)), middle = norm(jaws.at - vertex(after));
  if (at_corner)
    out.breaks = {Break{before, length - ends[0].seam, length}, Break{after, 0, ends[1].seam}};
  else
    out.breaks = {Break{after, middle - ends[0].seam, middle + ends[1].seam}};
  out.tips = {ends[0].tip, ends[1].tip};
  out.facings = {ends[0].facing, Segment{ends[1].facing.to, ends[1].facing.from}};
  out.tips[0].contact = Contact::jaw(pocket, 0);
  out.facings[0].contact = Contact::jaw(pocket, 1);
  out.facings[1].contact = Contact::jaw(pocket, 2);
  out.tips[1].contact = Contact::jaw(pocket, 3);
  out.tips[0].before = Contact::rail(before), out.tips[0].after = out.facings[0].contact;
  out.tips[1].before = out.facings[1].contact, out.tips[1].after = Contact::rail(after);
  return out;
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
  for (int k = 0; k < static_cast<int>(table.pockets.size()); ++k)
    if (table.pockets[static_cast<std::size_t>(k)].jaws) out.jaws.push_back(jaw_pieces(table, k));
  return out;
}

std::vector<Vec2d> outline(const Table& table, const std::vector<JawPieces>& jaws) {
  std::vector<Vec2d> out;
  const std::size_t n = table.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d from = table.vertices[i], along = direction_of({from, table.vertices[(i + 1) % n]});
    const auto on_rail = [&](const Break& b) { return b.rail == static_cast<int>(i); };
    // For each mouth at this rail: the half at the rail's start, both halves, or the half at its end.
    std::vector<std::pair<double, std::vector<Vec2d>>> parts;
    bool starts = false;
    for (const JawPieces& m : jaws) {
      std::vector<Vec2d> corners;
      const auto add = [&](const Vec2d& p) { corners.push_back(p); };
      const Break &first = m.breaks.front(), &last = m.breaks.back();
      if (on_rail(first)) add(from + along * first.begin), add(m.facings[0].from), add(m.facings[0].to);
      if (on_rail(last)) {
        add(m.facings[1].from), add(m.facings[1].to), add(from + along * last.end);
        starts = starts || !on_rail(first);
      }
      if (!corners.empty()) parts.emplace_back(on_rail(first) ? first.begin : 0, std::move(corners));
    }
    std::ranges::sort(parts, {}, &std::pair<double, std::vector<Vec2d>>::first);
    if (!starts) out.push_back(from);
    for (const auto& [place, corners] : parts) out.insert(out.end(), corners.begin(), corners.end());
  }
  return out;
}

}  // namespace bankshot
