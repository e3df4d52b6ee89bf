// SPDX-License-Identifier: MIT
#include "io/draw/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "sim/geometry/mouth.hpp"

namespace bankshot::drawing {
namespace {

/// One cushion; on a rectangle it runs from the left or from the bottom.
struct Edge {
  Vec2d from, to, out;  ///< `out`: unit vector away from the table
  Vec2d at(double part) const { return from + (to - from) * part; }
};

Edge edge(const Table& t, std::size_t i) {
  const Vec2d a = t.vertices[i], b = t.vertices[(i + 1) % t.vertices.size()], out = -perpendicular(b - a) / norm(b - a);
  const bool reversed = t.is_rectangle() && (b.x < a.x || b.y < a.y);
  return reversed ? Edge{b, a, out} : Edge{a, b, out};
}

double radius_px(const Canvas& c, const Pocket& p) { return std::max(c.px(p.radius), 3.0); }

/// Draws a pocket's hole, or with `grow` the leather around it. Without jaws the hole extends from the capture circle
/// into the rail; with jaws the circle already lies there.
void draw_hole(Canvas& c, const Pocket& p, double grow, const char* colour) {
  const Vec2d from = c.at(p.at), way = Canvas::flipped(view(c.table, p).out) * (p.jaws ? 0 : 0.75 * c.nose);
  c.add(R"(<path d="M{:.1f} {:.1f}l{:.1f} {:.1f}" stroke="{}" stroke-width="{:.1f}" stroke-linecap="round"/>)", from.x,
        from.y, way.x, way.y + 0.01, colour, 2 * (radius_px(c, p) + grow));
}

/// Draws the cloth between the jaws of a pocket: along a tip and a facing into the hole, and out again.
void draw_mouth(Canvas& c, const JawPieces& j) {
  std::string path;
  const auto arc = [&](const Bend& tip) { return fmt::format("A{0:.2f} {0:.2f} 0 0 1 ", c.px(tip.radius)); };
  const std::array<std::string, 6> ways{"M", arc(j.tips[0]), "L", "L", "L", arc(j.tips[1])};
  const std::array<Vec2d, 6> points = mouth(c.table, j);
  for (std::size_t i = 0; i < points.size(); ++i)
    path += fmt::format("{}{:.1f} {:.1f}", ways[i], c.at(points[i]).x, c.at(points[i]).y);
  c.add(R"(<path d="{}z" fill="{}"/>)", path, c.c.cloth);
}

bool under_pocket(const Canvas& c, const Vec2d& at) {
  return std::any_of(c.table.pockets.begin(), c.table.pockets.end(),
                     [&](const Pocket& p) { return norm(p.place() - at) < p.half(); });
}

double turned_along(const Edge& e) {
  const double turn = -degrees(std::atan2(e.to.y - e.from.y, e.to.x - e.from.x));
  constexpr double upright = 89.5;  // degrees; names of vertical rails always read upwards
  return turn > upright ? turn - 180 : turn < -upright - 1 ? turn + 180 : turn;
}

/// Draws a cushion's name on the wood, between two diamonds if there are any, and away from the line of aim.
void draw_name(Canvas& c, std::size_t i, const std::optional<Sight>& aim) {
  const Edge e = edge(c.table, i);
  const int spaces = c.table.is_rectangle() ? diamonds_along(c.table, static_cast<int>(i)) : 1;
  double part = spaces == 1 ? 0.5 : (spaces / 2 + 0.5) / spaces;
  if (aim && aim->cushion == static_cast<int>(i) && std::abs(aim->part - part) < 0.6 / spaces) part = 1 - part;
  constexpr double size = 13, down = 0.35;  // relative to the size: middle of the letters to the baseline
  const std::string& name = c.table.cushions[i];
  if (width_of(name, size) > c.px(norm(e.to - e.from)) / spaces) return;
  const double turn = turned_along(e);
  const Vec2d line = Vec2d{-std::sin(radians(turn)), std::cos(radians(turn))} * (down * size);
  c.words(c.at(e.at(part)) + Canvas::flipped(e.out) * ((c.nose + c.rail) / 2) + line, name,
          {size, c.c.wood_words, "middle", false, turn});
}

void draw_diamonds(Canvas& c, std::size_t i, bool words, const std::optional<Sight>& aim) {
  const Edge e = edge(c.table, i);
  const int spaces = diamonds_along(c.table, static_cast<int>(i));
  const Vec2d out = Canvas::flipped(e.out);
  std::string shapes;
  for (int k = 0; k <= spaces; ++k) {
    const Vec2d p = e.at(static_cast<double>(k) / spaces);
    if (under_pocket(c, p)) continue;
    const Vec2d at = c.at(p) + out * c.sight;
    if (k > 0 && k < spaces) shapes += fmt::format("M{:.1f} {:.1f}l4 5l-4 5l-4-5z", at.x, at.y - 5);
    const bool aimed = aim && aim->cushion == static_cast<int>(i) && std::abs(aim->diamonds - k) < 0.4;
    const Vec2d beside = at + out * (c.rail - c.sight + 12) + Vec2d{0, 4};
    if (words && !aimed) c.words(beside, std::to_string(k), {12, c.c.faint, "middle"});
  }
  c.add(R"(<path d="{}" fill="{}"/>)", shapes, c.c.sight);
}

/// Draws a pocket's name unless the number at the end of the line of aim is near.
void draw_pocket_name(Canvas& c, const Pocket& p, const std::optional<Sight>& aim) {
  const Vec2d out = Canvas::flipped(view(c.table, p).out);
  constexpr double room = 70;  // px; space for name and number
  if (norm(out) == 0 || (aim && c.px(norm(aim->at - p.place())) < room)) return;
  const bool corner = out.x != 0 && out.y != 0;
  const Vec2d at = c.at(p.place()) + (corner ? Vec2d{out.x > 0 ? c.rail : -c.rail, 0} : Vec2d{}) +
                   Vec2d{0, out.y > 0 ? c.rail + 17 : -c.rail - 9};
  c.words(at, p.name, {12, c.c.faint, !corner ? "middle" : out.x > 0 ? "end" : "start"});
}

}  // namespace

void draw_holes(Canvas& c) {
  for (const Pocket& p : c.table.pockets) draw_hole(c, p, 0, c.c.hole);
}

void draw_table(Canvas& c, bool words, const std::optional<Sight>& aim) {
  const Table& t = c.table;
  const auto outline = [&](double width, const char* colour, const char* join) {
    c.line(
        t.vertices, "polygon",
        fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.1f}" stroke-linejoin="{}")", colour, 2 * width, join));
  };
  outline(c.rail, c.c.wood, "round");
  for (const Pocket& p : t.pockets) draw_hole(c, p, 5, c.c.leather);
  outline(c.nose, c.c.cushion, "miter");
  c.line(t.vertices, "polygon", fmt::format(R"(fill="{}")", c.c.cloth));
  for (const JawPieces& j : obstacles(t).jaws) draw_mouth(c, j);
  for (std::size_t i = 0; i < t.vertices.size(); ++i) {
    if (t.is_rectangle()) draw_diamonds(c, i, words, aim);
    if (words) draw_name(c, i, aim);
  }
  draw_holes(c);
  if (words)
    for (const Pocket& p : t.pockets) draw_pocket_name(c, p, aim);
}

void draw_target(Canvas& c, const Puzzle& p, const Pocket* reached) {
  const auto ring = [&](const Vec2d& at, double radius, double width) {
    c.circle(at, radius, fmt::format(R"(fill="none" stroke="{}" stroke-width="{}")", c.c.halo, width + 3));
    c.circle(at, radius, fmt::format(R"(fill="none" stroke="{}" stroke-width="{}")", c.c.target, width));
  };
  for (const AimPoint& aim_point : aim_points_of(p)) {
    const Vec2d at = c.at(aim_point.at);
    if (reached && reached->at != aim_point.at) continue;
    if (aim_point.cuts) {
      const Ball& ball = p.others[static_cast<std::size_t>(aim_point.taken_by.index) - 1];
      ring(at, c.px(ball.body.radius) + 4, 2);
      continue;
    }
    if (aim_point.captures()) {
      ring(at, std::max(c.px(aim_point.reach), 4.0) + 2, 3);
      continue;
    }
    // The disc shows the true size of the target; the ring around it is visible for any size.
    const double reach = c.px(aim_point.reach);
    c.circle(at, reach, fmt::format(R"(fill="{0}" fill-opacity="0.3" stroke="{0}")", c.c.target));
    ring(at, std::max(reach, c.px(p.ball.body.radius)) + 5, 2);
    c.circle(at, 2.2, fmt::format(R"(fill="{}")", c.c.target));
  }
}

void draw_wanted_leave(Canvas& c, const Puzzle& p) {
  if (!p.leave) return;
  const std::string style = fmt::format(
      R"(fill="{0}" fill-opacity="0.15" stroke="{0}" stroke-width="1.5" stroke-dasharray="5 4")", c.c.target);
  if (const auto* place = std::get_if<LeavePlace>(&*p.leave)) {
    c.circle(c.at(place->at), c.px(place->within), style);
    c.circle(c.at(place->at), 2.2, fmt::format(R"(fill="{}")", c.c.target));
  }
  if (const auto* region = std::get_if<LeaveRegion>(&*p.leave)) c.line(region->vertices, "polygon", style);
}

void draw_spread(Canvas& c, const Spread& spread) {
  const Vec2d at = c.at(spread.at);
  for (const double share : {0.5, 0.9}) {
    // A normal distribution in the plane has this share within so many deviations.
    const double deviations = std::sqrt(-2 * std::log(1 - share));
    c.add(
        R"svg(<ellipse cx="{:.1f}" cy="{:.1f}" rx="{:.1f}" ry="{:.1f}" transform="rotate({:.1f} {:.1f} {:.1f})" fill="{}" fill-opacity="0.12" stroke="{}" stroke-opacity="0.6"/>)svg",
        at.x, at.y, c.px(deviations * spread.sigma[0]), c.px(deviations * spread.sigma[1]), -degrees(spread.angle),
        at.x, at.y, c.c.paths[2], c.c.paths[2]);
  }
}

void draw_opening(Canvas& c, const Puzzle& p, const Shot& shot, const Vec2d& heading) {
  const Pocket* const pocket = pocket_reached(p, shot);
  if (!pocket || shot.path.touches_jaws || !(norm(heading) > 0)) return;
  const auto aim_points = aim_points_of(p);
  const auto aim_point =
      std::ranges::min_element(aim_points, {}, [&](const AimPoint& m) { return m.apart(shot.path.arrival.at); });
  const Vec2d u = heading / norm(heading), left = perpendicular(u);
  const Gap<double> gap = aim_point->opening.gap(u, shot.verification.offset);
  const Vec2d across =
      aim_point->at + u * dot(u, (pocket->jaws ? pocket->jaws->at : shot.path.arrival.at) - aim_point->at);
  c.line({across + left * gap.low, across + left * gap.high}, "polyline",
         fmt::format(R"(fill="none" stroke="{}" stroke-width="3" stroke-linecap="round")", c.c.target));
}

}  // namespace bankshot::drawing
