// SPDX-License-Identifier: MIT
#include "bankshot/draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/draw/map.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "draw/escape.hpp"

namespace bankshot {
namespace {

constexpr double picture = 900;  // px, the longer side of the playing surface
constexpr double rail = 34;      // px, width of the wooden rail
constexpr double nose = 10;      // px, width of the rubber
constexpr double legend_line = 40;
constexpr const char* path_colours[] = {"#ffffff", "#ffd166", "#8ecae6", "#f4a261", "#cdb4db", "#b7e4c7"};

/// Table metres to picture pixels, y downwards.
class Canvas {
 public:
  explicit Canvas(const Table& t) : table_(t), low_(t.lowest()), size_(t.highest() - low_) {
    scale_ = picture / std::max(size_.x, size_.y);
  }
  double px(double metres) const { return metres * scale_; }
  Vec2d at(const Vec2d& p) const {
    return {rail + nose + px(p.x - low_.x), rail + nose + px(size_.y - (p.y - low_.y))};
  }

  template <class... A>
  void add(fmt::format_string<A...> f, A&&... args) {
    body_ += fmt::format(f, std::forward<A>(args)...) + "\n";
  }
  void circle(const Vec2d& p, double radius_px, std::string_view style) {
    const Vec2d c = at(p);
    add(R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" {}/>)", c.x, c.y, radius_px, style);
  }
  void polyline(const std::vector<Vec2d>& points, std::string_view tag, std::string_view style) {
    std::string list;
    for (const Vec2d& p : points) {
      const Vec2d c = at(p);
      list += fmt::format("{}{:.2f},{:.2f}", list.empty() ? "" : " ", c.x, c.y);
    }
    add(R"(<{} points="{}" {}/>)", tag, list, style);
  }
  /// Whole pockets are seen, also where they reach beyond the rail.
  std::string document(const std::string& title) const {
    Vec2d low{0, 0}, high{px(size_.x) + 2 * (rail + nose), px(size_.y) + 2 * (rail + nose)};
    for (const Pocket& p : table_.pockets) {
      const Vec2d c = at(p.at);
      low = {std::min(low.x, c.x - px(p.radius)), std::min(low.y, c.y - px(p.radius))};
      high = {std::max(high.x, c.x + px(p.radius)), std::max(high.y, c.y + px(p.radius))};
    }
    high.y += legend_ > 0 ? legend_line : 0;
    const Vec2d size = high - low;
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="{:.0f} {:.0f} {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" font-family="sans-serif">)"
        "\n<title>{}</title>\n{}</svg>\n",
        low.x, low.y, size.x, size.y, size.x, size.y, escaped(title), body_);
  }
  /// Adds an entry to the line below the table.
  void legend(const std::string& label, std::string_view colour) {
    const double y = px(size_.y) + 2 * (rail + nose) + 0.65 * legend_line, x = rail + legend_;
    add(R"(<rect x="{:.0f}" y="{:.0f}" width="26" height="5" fill="{}" stroke="#333" stroke-width="0.5"/>)", x, y - 8,
        colour);
    add(R"(<text x="{:.0f}" y="{:.0f}" font-size="18" fill="#333">{}</text>)", x + 34, y, escaped(label));
    constexpr double letter = 10;  // px, about
    legend_ += 70 + letter * static_cast<double>(label.size());
  }
  const Table& table() const { return table_; }

 private:
  const Table& table_;
  Vec2d low_, size_;
  double scale_;
  double legend_ = 0;  // px, the width of the legend so far
  std::string body_;
};

void draw_diamonds(Canvas& c) {
  const Table& t = c.table();
  const Vec2d low = t.lowest(), high = t.highest(), size = high - low;
  const auto mark = [&](const Vec2d& p, const Vec2d& outward) {
    for (const Pocket& pocket : t.pockets)
      if (norm(pocket.at - p) < 2 * pocket.radius) return;
    const Vec2d at = c.at(p) + outward * (nose + rail / 2);
    c.add(R"(<path d="M{:.1f} {:.1f}l4 4l-4 4l-4-4z" fill="#f3e9d2"/>)", at.x, at.y - 4);
  };
  const auto along = [&](double length, int spaces, auto&& place) {
    for (int i = 1; i < spaces; ++i) place(length * i / spaces);
  };
  const int nx = size.x >= size.y ? 8 : 4, ny = size.x >= size.y ? 4 : 8;
  along(size.x, nx, [&](double x) {
    mark({low.x + x, low.y}, {0, 1});
    mark({low.x + x, high.y}, {0, -1});
  });
  along(size.y, ny, [&](double y) {
    mark({low.x, low.y + y}, {-1, 0});
    mark({high.x, low.y + y}, {1, 0});
  });
}

void draw_pockets(Canvas& c) {
  for (const Pocket& p : c.table().pockets) c.circle(p.at, std::max(c.px(p.radius), 3.0), R"(fill="#111")");
}

void draw_table(Canvas& c) {
  const Table& t = c.table();
  if (t.is_rectangle()) {
    const Vec2d low = c.at({t.lowest().x, t.highest().y}), high = c.at({t.highest().x, t.lowest().y});
    const auto frame = [&](double grow, double round, std::string_view fill) {
      c.add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" rx="{:.0f}" fill="{}"/>)", low.x - grow,
            low.y - grow, high.x - low.x + 2 * grow, high.y - low.y + 2 * grow, round, fill);
    };
    frame(nose + rail, 16, "#5b3a1e");
    frame(nose, 3, "#14532d");
    frame(0, 0, "#1f7a4d");
    draw_diamonds(c);
  } else {
    // Joins are drawn with the strokes, so a polygon's rail follows its outline.
    c.polyline(t.vertices, "polygon",
               fmt::format(R"(fill="none" stroke="#5b3a1e" stroke-width="{}" stroke-linejoin="round")",
                           2 * (nose + rail / 2)));
    c.polyline(t.vertices, "polygon",
               fmt::format(R"(fill="none" stroke="#14532d" stroke-width="{}" stroke-linejoin="round")", 2 * nose));
    c.polyline(t.vertices, "polygon", R"(fill="#1f7a4d")");
  }
  draw_pockets(c);
}

/// Points along one arc: its ends, and points between where it bends.
std::vector<Vec2d> outline(const Leg& leg, int pieces) {
  if (!(std::abs(cross(leg.arc.velocity, leg.arc.acceleration)) > 1e-12)) pieces = 1;
  std::vector<Vec2d> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(leg.arc.position(leg.duration * i / pieces));
  return points;
}

/// The same along a path.
std::vector<Vec2d> outline(const Trajectory& t) {
  constexpr int pieces = 24;
  std::vector<Vec2d> points{t.events.front().state.at};
  for (const Leg& leg : t.legs) {
    const std::vector<Vec2d> more = outline(leg, pieces);
    points.insert(points.end(), more.begin() + 1, more.end());
  }
  return points;
}

double ball_px(const Canvas& c, const Ball& ball) { return std::max(c.px(ball.body.radius), 4.0); }

/// `others`: how many paths more are drawn; many are drawn faintly.
void draw_path(Canvas& c, const Trajectory& t, const Ball& ball, std::string_view colour, bool best,
               std::size_t others = 0) {
  const char* join = R"(stroke-linejoin="round" stroke-linecap="round")";
  c.polyline(
      outline(t), "polyline",
      fmt::format(R"(fill="none" stroke="{}" stroke-width="{}" {} stroke-opacity="{}")", colour, best ? 2.5 : 1.5, join,
                  best         ? 1.0
                  : others > 6 ? 0.4
                               : 0.75));
  if (!best) return;
  constexpr std::size_t most_ghosts = 60;  // more would hide the path
  const auto bounces = t.sequence().size();
  for (const Record& e : t.events)
    if (e.kind == EventKind::cushion && bounces <= most_ghosts)
      c.circle(e.state.at, ball_px(c, ball),
               fmt::format(R"(fill="none" stroke="{}" stroke-width="1" stroke-opacity="0.7")", colour));
}

void draw_ball(Canvas& c, const Vec2d& at, const Ball& ball, std::string_view style) {
  c.circle(at, ball_px(c, ball), style);
}

/// The aims of the margin as one shaded region, leg by leg between its two outermost paths.
void draw_fan(Canvas& c, const Puzzle& p, const Shot& shot) {
  const auto& m = shot.margin->angle;
  if (!m[0] || !m[1]) return;
  constexpr int strips = 8, pieces = 8;
  std::vector<Leg> before;
  for (int i = 0; i <= strips; ++i) {
    Shot edge = shot;
    edge.launch.angle = wrap_angle(shot.launch.angle + *m[0] + (*m[1] - *m[0]) * i / strips);
    const std::vector<Leg> legs = simulate(as_request(p, edge)).legs;
    for (std::size_t k = 0; k < std::min(legs.size(), before.size()); ++k) {
      std::vector<Vec2d> strip = outline(before[k], pieces), back = outline(legs[k], pieces);
      strip.insert(strip.end(), back.rbegin(), back.rend());
      c.polyline(strip, "polygon", R"(fill="#ffd166" fill-opacity="0.45")");
    }
    before = legs;
  }
}

void draw_target(Canvas& c, const Puzzle& p) {
  const char* ring = R"(fill="none" stroke="#ef476f" stroke-width="2.5")";
  for (const Mark& mark : marks_of(p.target, Boundary(p.table, p.ball.body))) {
    c.circle(mark.at, std::max(c.px(mark.reach), mark.captures() ? 6.0 : 7.0), ring);
    if (!mark.captures()) c.circle(mark.at, 2.5, R"(fill="#ef476f")");
  }
}

}  // namespace

std::string draw(const ShotRequest& request, const Trajectory& trajectory) {
  Canvas c(request.table);
  draw_table(c);
  draw_path(c, trajectory, request.ball, path_colours[0], true);
  draw_ball(c, request.ball.at, request.ball, R"(fill="#ffffff")");
  draw_ball(c, trajectory.events.back().state.at, request.ball,
            R"(fill="#ffffff" fill-opacity="0.6" stroke="#ef476f" stroke-width="2")");
  return c.document(fmt::format("{:.3f} m/s at {:.2f} degrees", request.launch.speed, degrees(request.launch.angle)));
}

std::string draw(const Table& table, const Ball& ball, std::span<const LabelledPath> paths) {
  Canvas c(table);
  draw_table(c);
  std::string title;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const char* colour = path_colours[i % std::size(path_colours)];
    draw_path(c, paths[i].trajectory, ball, colour, true);
    draw_ball(c, paths[i].trajectory.events.back().state.at, ball,
              fmt::format(R"(fill="{}" fill-opacity="0.6")", colour));
    c.legend(paths[i].label, colour);
    title += (title.empty() ? "" : ", ") + paths[i].label;
  }
  draw_ball(c, ball.at, ball, R"(fill="#ffffff")");
  return c.document(title);
}

std::string draw(const Puzzle& puzzle, const Answer& answer) {
  Canvas c(puzzle.table);
  draw_table(c);
  if (!answer.shots.empty() && answer.shots[0].margin) draw_fan(c, puzzle, answer.shots[0]);
  for (std::size_t i = answer.shots.size(); i-- > 0;) {
    const Shot& shot = answer.shots[i];
    draw_path(c, simulate(as_request(puzzle, shot)), puzzle.ball, path_colours[i % std::size(path_colours)], i == 0,
              answer.shots.size() - 1);
  }
  if (!answer.shots.empty())
    draw_ball(c, answer.shots[0].arrival.at, puzzle.ball, R"(fill="#ffffff" fill-opacity="0.5")");
  draw_target(c, puzzle);
  draw_ball(c, puzzle.ball.at, puzzle.ball, R"(fill="#ffffff")");
  return c.document(fmt::format("{}: {}", name(answer.status), answer.message));
}

std::string draw(const Puzzle& puzzle, std::span<const Cell> cells, std::span<const LegendEntry> legend,
                 const std::string& title) {
  Canvas c(puzzle.table);
  draw_table(c);
  constexpr double seam = 0.5;  // px more than its size: no cloth shines through between two cells
  c.add(R"(<g shape-rendering="crispEdges">)");
  for (const Cell& cell : cells) {
    const Vec2d a = c.at({cell.low.x, cell.high.y}), b = c.at({cell.high.x, cell.low.y});
    c.add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", a.x, a.y, b.x - a.x + seam,
          b.y - a.y + seam, cell.fill);
  }
  c.add("</g>");
  for (const Cell& cell : cells) {
    const Vec2d size = cell.high - cell.low, middle = c.at(cell.low + size / 2.0);
    const double tick = 0.4 * c.px(std::min(size.x, size.y));
    if (!cell.aim || tick < 3) continue;
    const Vec2d u = direction(*cell.aim) * tick;
    c.add(R"(<path d="M{:.1f} {:.1f}l{:.1f} {:.1f}" stroke="{}" stroke-width="1.2" stroke-opacity="0.7"/>)", middle.x,
          middle.y, u.x, -u.y, cell.ink);
  }
  draw_pockets(c);
  draw_target(c, puzzle);
  for (const LegendEntry& entry : legend) c.legend(entry.label, entry.colour);
  return c.document(title);
}

}  // namespace bankshot
