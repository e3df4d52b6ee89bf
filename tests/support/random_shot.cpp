// SPDX-License-Identifier: MIT
#include "support/random_shot.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::test {
namespace {

constexpr int most_cushions = 200;

/// Returns 0 sometimes, otherwise a log-uniform number of either sign.
double near_zero(Random& r, double least, double most) {
  if (r.chance(0.2)) return 0;
  const double size = r.log_uniform(least, most);
  return r.chance(0.5) ? size : -size;
}

Table random_table(Random& r, ShotFamily f) {
  if (f == ShotFamily::convex) return random_polygon(r, true);
  if (f == ShotFamily::reflex) return random_polygon(r, false);
  if (f == ShotFamily::discrete) return rectangle_table(r.integer(1, 3), r.integer(1, 2));
  if (f != ShotFamily::uniform && f != ShotFamily::moved && r.chance(0.3)) return random_polygon(r, true);
  const double length = f == ShotFamily::moved ? r.log_uniform(1e-3, 1e3) : r.log_uniform(0.5, 6);
  Table t = rectangle_table(length, length * r.uniform(0.4, 1));
  if (f != ShotFamily::moved) return t;
  const Vec2d by{near_zero(r, 1e-3, 1e4), near_zero(r, 1e-3, 1e4)};
  for (Vec2d& v : t.vertices) v += by;
  return t;
}

Physics random_physics(Random& r, ShotFamily f, double radius) {
  Restitution e{r.uniform(0.5, 1)};
  if (f == ShotFamily::discrete) e = Restitution{0.5 * r.integer(0, 2)};
  if (f == ShotFamily::dead) e = Restitution{r.chance(0.2) ? 0 : r.uniform(0, 0.4)};
  if (r.chance(0.1)) e.per_speed = r.uniform(-0.05, 0.02);
  const double slick = f == ShotFamily::slick ? 1 : 0;
  const auto friction = [&](double low, double high) {
    return r.chance(0.3 * slick) ? 0 : r.log_uniform(slick > 0 ? low * 1e-6 : low, high);
  };
  const bool drag = f == ShotFamily::drag, mathavan = f == ShotFamily::mathavan;
  const bool tilted = f == ShotFamily::tilted;
  const double way = tilted ? r.uniform(0, radians(360)) : 0, rise = tilted ? r.log_uniform(1e-5, 0.03) : 0;
  const Vec2d tilt{rise * std::cos(way), rise * std::sin(way)};
  if (!drag && !mathavan && r.chance(0.15))
    return {.motion = Rolling{.friction = friction(0.005, 0.05)}, .cushion = Mirror{e.at_rest}, .tilt = tilt};
  Physics p = spin_physics({radius});
  SlideRoll& m = std::get<SlideRoll>(p.motion);
  m.sliding_friction = friction(0.1, 0.4);
  m.rolling_friction = friction(0.003, 0.03);
  m.spinning_friction = friction(0.1, 1) * radius;
  p.tilt = tilt;
  if (drag || (tilted && r.chance(0.3))) m.rolling_friction.per_speed = r.log_uniform(1e-12, 1);
  Han2005& h = std::get<Han2005>(p.cushion);
  h.restitution = e;
  h.friction = r.chance(0.1) ? 0 : r.uniform(0.05, 0.4);
  h.height = radius * r.uniform(1.05, 1.6);
  const double height = h.height;
  if (r.chance(0.2)) p.cushion = Mirror{e};
  if (tilted && r.chance(0.2)) p.cushion = Stronge{.height = height, .restitution = e};
  if (mathavan)
    p.cushion = Mathavan2010{
        .height = height, .restitution = e, .friction = r.uniform(0, 0.4), .sliding_friction = m.sliding_friction};
  return p;
}

LaunchSpin random_spin(Random& r, ShotFamily f) {
  if (f == ShotFamily::discrete)
    return {0.5 * r.integer(-2, 2), 0.5 * r.integer(-2, 2), r.chance(0.8) ? 0 : 0.5 * r.integer(-2, 2)};
  if (f == ShotFamily::masse) return {r.uniform(-3, 1), r.uniform(-2, 2), r.uniform(-3, 3)};
  LaunchSpin s{r.uniform(-1, 1.3), r.uniform(-1, 1), r.chance(0.2) ? r.uniform(-1, 1) : 0};
  if (r.chance(0.1)) s.top = 1;
  if (r.chance(0.1)) s.top = 1 + near_zero(r, 1e-16, 1e-6);
  return s;
}

double angle_of(const Vec2d& d) { return std::atan2(d.y, d.x); }

/// Draws a place and an aim [rad] of the family.
bool place(Random& r, ShotFamily f, const Boundary& b, const Table& t, Vec2d& at, double& aim) {
  const Vec2d low = t.lowest(), high = t.highest();
  at = {r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
  aim = radians(r.uniform(0, 360));
  const Wall& w = b.walls[static_cast<std::size_t>(r.integer(0, static_cast<int>(b.walls.size()) - 1))];
  if (dot(w.to - w.from, w.along) <= 0) return false;
  const Vec2d on = w.from + (w.to - w.from) * r.uniform(0, 1);
  if (f == ShotFamily::discrete) {
    const double R = b.body.radius;
    at = {low.x + R + (high.x - low.x - 2 * R) * r.integer(0, 8) / 8,
          low.y + R + (high.y - low.y - 2 * R) * r.integer(0, 8) / 8};
    aim = radians(15.0 * r.integer(0, 23));
  } else if (f == ShotFamily::frozen) {
    at = on + w.normal * std::abs(near_zero(r, 1e-16, 1e-9));
    if (r.chance(0.3)) aim = angle_of(r.chance(0.5) ? w.along : -w.along) + near_zero(r, 1e-16, 1e-3);
  } else if (f == ShotFamily::corners) {
    aim = angle_of(w.to - at) + near_zero(r, 1e-16, 1e-3);
  } else if (f == ShotFamily::grazing) {
    at = on + w.normal * r.log_uniform(1e-12, 0.1);
    aim = angle_of(r.chance(0.5) ? w.along : -w.along) + near_zero(r, 1e-12, 1e-2);
  } else if (f == ShotFamily::masse && r.chance(0.8)) {
    at = on + w.normal * (r.chance(0.5) ? std::abs(near_zero(r, 1e-16, 1e-9)) : r.log_uniform(1e-6, 0.1));
  }
  return b.clearance(at) >= -b.touch;
}

}  // namespace

std::string name(ShotFamily family) {
  constexpr const char* names[] = {"uniform", "discrete", "frozen", "corners", "grazing", "masse",    "speeds", "dead",
                                   "slick",   "convex",   "reflex", "moved",   "drag",    "mathavan", "tilted"};
  return names[static_cast<int>(family)];
}

ShotRequest random_shot(Random& r, ShotFamily f) {
  for (;;) {
    ShotRequest shot;
    shot.table = random_table(r, f);
    shot.ball.body.radius = f == ShotFamily::discrete ? 0.0625
                            : f == ShotFamily::moved  ? shot.table.diagonal() * r.uniform(0.005, 0.05)
                                                      : 0.0285;
    shot.physics = random_physics(r, f, shot.ball.body.radius);
    if (is_straight(shot.physics) && r.chance(0.2)) {
      shot.ball.body.radius = 0;
    }
    const Boundary boundary(shot.table, shot.ball.body);
    double aim = 0;
    if (!place(r, f, boundary, shot.table, shot.ball.at, aim)) continue;
    // The angle goes through degrees, as in a document, so that the document replays the same bits.
    shot.launch = {f == ShotFamily::speeds  ? r.log_uniform(1e-6, 30)
                   : f == ShotFamily::masse ? r.log_uniform(0.05, 4)
                                            : r.log_uniform(0.1, 10),
                   wrap_angle(radians(exact_degrees(wrap_angle(aim))))};
    if (f == ShotFamily::discrete) shot.launch.speed = r.integer(1, 4);
    if (!is_straight(shot.physics)) shot.spin = random_spin(r, f);
    shot.until.cushions = most_cushions;
    return shot;
  }
}

std::string write_shot(const ShotRequest& shot) {
  using nlohmann::json;
  Puzzle p{.table = shot.table,
           .physics = shot.physics,
           .ball = shot.ball,
           .spin = shot.spin,
           .target = PointTarget{shot.ball.at}};
  json j = json::parse(write_puzzle(p));
  for (const char* key : {"target", "cushions", "speed", "prefer", "noise", "budget"}) j.erase(key);
  j["shot"] = {{"speed", shot.launch.speed}, {"angle", exact_degrees(shot.launch.angle)}};
  for (const Ball& other : shot.others)
    j["others"].push_back(
        {{"id", other.id}, {"at", {other.at.x, other.at.y}}, {"radius", other.body.radius}, {"mass", other.body.mass}});
  if (shot.until.time) j["until"] = {{"time", *shot.until.time}};
  if (shot.until.cushions) j["until"] = {{"cushions", *shot.until.cushions}};
  return j.dump();
}

}  // namespace bankshot::test
