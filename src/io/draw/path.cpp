// SPDX-License-Identifier: MIT
#include "io/draw/path.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::drawing {
namespace {

/// Returns points along one arc: its ends and, if it is curved, points between.
std::vector<Vec2d> outline(const Leg& leg, int pieces) {
  if (!(std::abs(cross(leg.arc.velocity, leg.arc.acceleration)) > 1e-12)) pieces = 1;
  std::vector<Vec2d> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(leg.arc.position(leg.duration * i / pieces));
  return points;
}

/// Splits the path at bounces and hits; each stretch is a list of points.
std::vector<std::vector<Vec2d>> stretches(const Trajectory& t) {
  constexpr int pieces = 24;
  std::vector<std::vector<Vec2d>> out{{t.events.front().state.at}};
  auto bounce = t.events.begin();
  for (const Leg& leg : t.legs) {
    bool bounced = false;
    for (; bounce != t.events.end() && bounce->time <= leg.begin; ++bounce)
      bounced = bounced || is_bounce(bounce->kind) || bounce->kind == EventKind::ball;
    if (bounced) out.push_back({leg.start.at});
    const std::vector<Vec2d> more = outline(leg, pieces);
    out.back().insert(out.back().end(), more.begin() + 1, more.end());
  }
  return out;
}

/// Draws a filled arrowhead whose tip is past the middle of a stretch, if there is room.
void draw_head(Canvas& c, const std::vector<Vec2d>& stretch, const PathStyle& style) {
  constexpr double place = 0.58, least_length = 11;  // fraction of the stretch; px
  const double length = std::max(least_length, 5 * style.width), half_width = 0.36 * length, least = 3.5 * length;
  double all = 0;
  for (std::size_t i = 1; i < stretch.size(); ++i) all += norm(stretch[i] - stretch[i - 1]);
  if (c.px(all) < least) return;
  double left = place * all;
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    const Vec2d step = stretch[i] - stretch[i - 1];
    if (left > norm(step)) {
      left -= norm(step);
      continue;
    }
    const Vec2d u = Canvas::flipped(step) / norm(step), tip = c.at(stretch[i - 1] + step * (left / norm(step)));
    const Vec2d back = tip - u * length, side = perpendicular(u) * half_width;
    c.add(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z" fill="{}" fill-opacity="{}"/>)", tip.x, tip.y,
          back.x + side.x, back.y + side.y, back.x - side.x, back.y - side.y, style.colour, style.opacity);
    return;
  }
}

/// Returns the position of a bounce's number: on the rubber that the ball meets.
Vec2d on_cushion(const Canvas& c, const Boundary& b, const Record& bounce) {
  const Vec2d out = Canvas::flipped(-b.normal(bounce.contact, bounce.state.at));
  return c.at(bounce.state.at) + out * (c.px(b.body.radius) + c.nose / 2);
}

/// Moves a label along its cushion until it covers no other label.
Vec2d apart(Vec2d at, std::vector<Vec2d>& taken, const Vec2d& along, double room) {
  const auto covers = [&](const Vec2d& other) { return norm(other - at) < room; };
  while (norm(along) > 0 && std::any_of(taken.begin(), taken.end(), covers)) at += along * (room / 2);
  taken.push_back(at);
  return at;
}

void draw_bounces(Canvas& c, const Ball& ball, const Trajectory& t, const PathStyle& style) {
  constexpr std::ptrdiff_t most = 60;  // more would hide the path
  if (std::ranges::count(t.events, EventKind::ball, &Record::kind) + t.cushions > most) return;
  const Boundary boundary(c.table, ball.body);
  std::vector<Vec2d> taken;
  int number = 0;
  for (const Record& e : t.events) {
    if (e.kind != EventKind::cushion && e.kind != EventKind::ball) continue;
    c.circle(c.at(e.state.at), std::max(c.px(ball.body.radius), 3.0),
             fmt::format(R"(fill="none" stroke="{}" stroke-width="1.2" stroke-opacity="0.75")", style.colour));
    if (!style.numbers || e.kind == EventKind::ball) continue;
    constexpr double size = 14;
    const Vec2d along = perpendicular(boundary.normal(e.contact, e.state.at));
    const Vec2d at = apart(on_cushion(c, boundary, e), taken, Canvas::flipped(along), size);
    c.words(at + Vec2d{0, 0.36 * size}, std::to_string(++number), {size, c.c.cushion_words, "middle", true});
  }
}

}  // namespace

void draw_path(Canvas& c, const Ball& ball, const Trajectory& t, const PathStyle& style) {
  const auto parts = stretches(t);
  std::vector<Vec2d> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin() + (all.empty() ? 0 : 1), part.end());
  c.line(all, "polyline",
         fmt::format(R"(fill="none" stroke="{}" stroke-width="{}" stroke-linejoin="round" stroke-linecap="round"{}{})",
                     style.colour, style.width,
                     style.opacity < 1 ? fmt::format(R"( stroke-opacity="{}")", style.opacity) : "",
                     style.dashed ? R"( stroke-dasharray="9 6")" : ""));
  constexpr std::size_t most_heads = 24;
  if (parts.size() <= most_heads)
    for (const auto& part : parts) draw_head(c, part, style);
  if (style.ghosts) draw_bounces(c, ball, t, style);
}

double dot_step(const Trajectory& t) {
  constexpr double most = 40;
  double step = 0.5;
  while (t.events.back().time > most * step) step *= 2;
  return step;
}

void draw_dots(Canvas& c, const ShotRequest& shot, const Trajectory& t, std::string_view colour) {
  const double step = dot_step(t);
  std::size_t leg = 0;
  for (int i = 1; i * step < t.events.back().time; ++i) {
    while (leg + 1 < t.legs.size() && t.legs[leg + 1].begin <= i * step) ++leg;
    const Vec2d at = c.at(state_at(shot, t.legs[leg], i * step - t.legs[leg].begin).at);
    c.circle(at, 3.4, fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.8")", c.c.cloth, colour));
  }
}

void draw_tag(Canvas& c, const Ball& ball, const Trajectory& t, int number, std::string_view colour) {
  const auto bounce =
      std::find_if(t.events.begin(), t.events.end(), [](const Record& e) { return e.kind == EventKind::cushion; });
  const Vec2d at = bounce != t.events.end() ? on_cushion(c, Boundary(c.table, ball.body), *bounce)
                                            : c.at((ball.at + t.events.back().state.at) * 0.5);
  c.circle(at, 9, fmt::format(R"(fill="{}" stroke="{}")", colour, c.c.halo));
  c.words(at + Vec2d{0, 4.4}, std::to_string(number), {12, c.c.halo, "middle", true});
}

void draw_band(Canvas& c, const Puzzle& p, const Shot& shot) {
  if (!shot.robustness.margin || !shot.robustness.margin->angle[0] || !shot.robustness.margin->angle[1]) return;
  const double low = *shot.robustness.margin->angle[0], high = *shot.robustness.margin->angle[1];
  constexpr int strips = 8, pieces = 8;
  // The strips are opaque inside a translucent group, so that overlaps and seams are not visible.
  c.add(R"(<g opacity="0.2" fill="{0}" stroke="{0}" stroke-width="0.6">)", c.c.band);
  std::vector<Leg> before;
  for (int i = 0; i <= strips; ++i) {
    Shot edge = shot;
    edge.launch.angle = wrap_angle(shot.launch.angle + low + (high - low) * i / strips);
    const std::vector<Leg> legs = path_of(p, edge).legs;
    for (std::size_t k = 0; k < std::min(legs.size(), before.size()); ++k) {
      std::vector<Vec2d> strip = outline(before[k], pieces), back = outline(legs[k], pieces);
      strip.insert(strip.end(), back.rbegin(), back.rend());
      c.line(strip, "polygon", "");
    }
    before = legs;
  }
  c.add("</g>");
}

void draw_aim(Canvas& c, const Vec2d& from, const Sight& aim) {
  const Table& t = c.table;
  const auto i = static_cast<std::size_t>(aim.cushion);
  const Vec2d a = t.vertices[i], b = t.vertices[(i + 1) % t.vertices.size()];
  const Vec2d out = Canvas::flipped(-perpendicular(b - a) / norm(b - a));
  const Vec2d begin = c.at(from), u = (c.at(aim.at) - begin) / norm(c.at(aim.at) - begin);
  // Diamonds are drawn at another distance if their true place would be hidden.
  const double shifted = t.is_rectangle() ? (c.sight - c.px(sight_distance(t))) / dot(u, out) : 0;
  const Vec2d end = c.at(aim.at) + u * shifted;
  c.add(
      R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}" stroke-width="1.6" stroke-dasharray="2 5" stroke-linecap="round"/>)",
      begin.x, begin.y, end.x, end.y, c.c.aim);
  c.circle(end, 4.5, fmt::format(R"(fill="{}" stroke="{}" stroke-width="1.5")", c.c.aim, c.c.sight));
  if (!t.is_rectangle()) return;
  const double beyond = c.rail - c.sight + (out.y == 0 ? 20 : 12);
  c.words(end + out * beyond + Vec2d{0, 5}, fmt::format("{:.2f}", aim.diamonds), {14, c.c.aim, "middle", true});
}

namespace {

/// Returns the number of a pool ball, 1 to 15, or 0.
int number_of(const Ball& ball) {
  int number = 0;
  const char* const end = ball.id.data() + ball.id.size();
  const auto [rest, error] = std::from_chars(ball.id.data(), end, number);
  return error == std::errc() && rest == end && number >= 1 && number <= 15 ? number : 0;
}

/// Returns the colour of a carom ball, whose name is its colour.
std::optional<std::string_view> named_colour(const Canvas& c, std::string_view id) {
  if (id == "yellow") return c.c.pool[0];
  if (id == "red") return c.c.pool[2];
  if (id == "white") return c.c.ball;
  return {};
}

}  // namespace

std::string_view colour_of(const Canvas& c, const Ball& ball) {
  const int number = number_of(ball);
  if (number == 0) return named_colour(c, ball.id).value_or(c.c.paths[5]);
  return c.c.pool[static_cast<std::size_t>((number - 1) % 8)];
}

void draw_other(Canvas& c, const Ball& ball, const Vec2d& at, double opacity) {
  const double radius = std::max(c.px(ball.body.radius), 4.0);
  const Vec2d centre = c.at(at);
  const bool striped = number_of(ball) > 8;
  c.add(R"(<g opacity="{}">)", opacity);
  c.circle(centre, radius,
           fmt::format(R"(fill="{}" stroke="{}" stroke-width="1")", striped ? "#ffffff" : colour_of(c, ball),
                       c.c.ball_edge));
  if (striped)  // a coloured band across the ball
    c.add(
        R"(<path d="M{0:.1f} {1:.1f}A{2:.1f} {2:.1f} 0 0 1 {3:.1f} {1:.1f}L{3:.1f} {4:.1f}A{2:.1f} {2:.1f} 0 0 1 {0:.1f} {4:.1f}z" fill="{5}"/>)",
        centre.x - 0.83 * radius, centre.y - 0.55 * radius, radius, centre.x + 0.83 * radius, centre.y + 0.55 * radius,
        colour_of(c, ball));
  if (named_colour(c, ball.id)) return c.add("</g>");
  c.circle(centre, 0.62 * radius, R"(fill="#ffffff")");
  if (ball.id.size() <= 2)
    c.words(centre + Vec2d{0, 0.33 * radius}, ball.id, {0.95 * radius, "#111111", "middle", true});
  c.add("</g>");
}

void draw_ball(Canvas& c, const Ball& ball, const Vec2d& at, double opacity, std::string_view edge) {
  c.circle(c.at(at), std::max(c.px(ball.body.radius), 4.0),
           fmt::format(R"(fill="{}" fill-opacity="{}" stroke="{}" stroke-width="1.3")", c.c.ball, opacity,
                       edge.empty() ? c.c.ball_edge : edge));
}

void draw_stop(Canvas& c, const Ball& ball, const Vec2d& at, bool stops) {
  const Vec2d centre = c.at(at);
  const double radius = std::max(c.px(ball.body.radius), 4.0), arm = 0.7 * radius;
  if (stops) {
    draw_ball(c, ball, at, 0.75);
    c.circle(centre, radius + 4, fmt::format(R"(fill="none" stroke="{}" stroke-width="2")", c.c.paths[0]));
    return;
  }
  c.add(R"(<path d="M{0:.1f} {1:.1f}l{2:.1f} {2:.1f}m0 {3:.1f}l{3:.1f} {2:.1f}" stroke="{4}" stroke-width="3"/>)",
        centre.x - arm, centre.y - arm, 2 * arm, -2 * arm, c.c.aim);
}

}  // namespace bankshot::drawing
