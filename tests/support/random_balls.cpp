// SPDX-License-Identifier: MIT
#include "support/random_balls.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/scene.hpp"

namespace bankshot::test {
namespace {

bool fits(const ShotRequest& shot, const Ball& ball) {
  const Boundary boundary(shot.table, ball.body);
  if (boundary.clearance(ball.at) < 0 || boundary.pocket_around(ball.at)) return false;
  const auto apart = [&](const Ball& other) {
    return norm(ball.at - other.at) >= touching_distance(ball.body, other.body);
  };
  return apart(shot.ball) && std::ranges::all_of(shot.others, apart);
}

/// Draws a place at a cushion, or beside another ball with a gap of at most 1e-9 m.
Vec2d touching(Random& r, const ShotRequest& shot, const Body& body) {
  const Vec2d size = shot.table.highest();
  if (r.chance(0.25))
    return {r.uniform(body.radius, size.x - body.radius), r.chance(0.5) ? body.radius : size.y - body.radius};
  const int which = r.integer(0, static_cast<int>(shot.others.size()));
  const Ball& beside = which == 0 ? shot.ball : shot.others[static_cast<std::size_t>(which) - 1];
  const double way = r.chance(0.3) ? radians(60.0 * r.integer(0, 5)) : r.uniform(0, 7);
  const double gap = r.chance(0.5) ? 0 : r.log_uniform(1e-16, 1e-9);
  return beside.at + Vec2d{std::cos(way), std::sin(way)} * (touching_distance(beside.body, body) + gap);
}

void place_others(Random& r, ShotRequest& shot, BallFamily family) {
  const bool close = family == BallFamily::frozen || family == BallFamily::slow || r.chance(0.1);
  const int count = r.chance(0.3) ? 1 : r.integer(2, 15);
  const Vec2d size = shot.table.highest();
  for (int i = 0, tries = 0; i < count && tries < 300; ++tries) {
    Ball ball{{}, shot.ball.body, std::to_string(i + 1)};
    if (family == BallFamily::sizes) ball.body = {r.uniform(0.02, 0.036), r.log_uniform(0.05, 0.5)};
    ball.at = close && r.chance(0.8) ? touching(r, shot, ball.body) : Vec2d{r.uniform(0, size.x), r.uniform(0, size.y)};
    if (!fits(shot, ball)) continue;
    shot.others.push_back(ball);
    ++i;
  }
}

}  // namespace

std::string name(BallFamily family) {
  constexpr const char* names[] = {"scattered", "sizes", "frozen", "slow", "elastic", "drag", "rolling", "ideal"};
  return names[static_cast<int>(family)];
}

ShotRequest random_balls(Random& r, BallFamily family) {
  const char* physics = family == BallFamily::rolling ? "rolling" : family == BallFamily::ideal ? "ideal" : "spin";
  const char* tables[] = {"pool-9ft", "pool-7ft", "snooker-12ft", "carom-10ft"};
  const Scene scene = preset_scene(tables[r.integer(0, 3)], physics);
  ShotRequest shot{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  if (r.chance(0.3)) shot.table = rectangle_table(r.uniform(0.6, 3), r.uniform(0.4, 1.5));
  const Vec2d size = shot.table.highest();
  const double R = shot.ball.body.radius;
  const Boundary boundary(shot.table, shot.ball.body);
  do shot.ball.at = {r.uniform(R, size.x - R), r.uniform(R, size.y - R)};
  while (boundary.pocket_around(shot.ball.at));
  if (family == BallFamily::sizes) {
    shot.physics.ball_ball = {r.uniform(0, 1), r.uniform(0, 0.3)};
    shot.ball.body.mass = r.log_uniform(0.05, 0.5);
  }
  if (family == BallFamily::elastic) shot.physics.ball_ball = {1, 0};
  if (family == BallFamily::drag)
    std::get<SlideRoll>(shot.physics.motion).rolling_friction = {r.uniform(0.004, 0.01), r.uniform(0.0005, 0.003)};
  place_others(r, shot, family);
  const double speed = family == BallFamily::slow ? r.log_uniform(1e-5, 1e-2) : r.log_uniform(0.05, 10);
  double angle = r.uniform(0, 6.28);
  if (!shot.others.empty() && r.chance(0.7)) {
    const auto which = static_cast<std::size_t>(r.integer(0, static_cast<int>(shot.others.size()) - 1));
    const Vec2d d = shot.others[which].at - shot.ball.at;
    angle = std::atan2(d.y, d.x) + r.uniform(-1, 1) * std::min(1.0, 2 * R / norm(d));
  }
  shot.launch = {speed, wrap_angle(angle)};
  if (!is_straight(shot.physics) && r.chance(0.8))
    shot.spin = {r.chance(0.3) ? 1 : r.uniform(-1.2, 1.2), r.chance(0.3) ? 0 : r.uniform(-0.8, 0.8),
                 r.chance(0.7) ? 0 : r.uniform(-0.5, 0.5)};
  if (family == BallFamily::ideal) shot.until.time = 5;
  return shot;
}

ShotRequest break_shot(Random& r, double gap) {
  const Scene scene = preset_scene("pool-9ft");
  ShotRequest shot{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  const double R = scene.ball.body.radius, step = 2 * R + gap, half_height = std::sqrt(0.75);
  const Vec2d foot{1.905, 0.635};
  int number = 1;
  for (int row = 0; row < 5; ++row)
    for (int k = 0; k <= row; ++k, ++number)
      shot.others.push_back(
          {foot + Vec2d{row * step * half_height, (k - row / 2.0) * step}, scene.ball.body, std::to_string(number)});
  shot.ball.at = {r.uniform(0.2, 0.635), r.uniform(0.2, 1.07)};
  const Vec2d aim = foot + Vec2d{0, r.uniform(-0.02, 0.02)} - shot.ball.at;
  shot.launch = {r.uniform(6, 10), wrap_angle(std::atan2(aim.y, aim.x))};
  shot.spin = {r.uniform(-0.5, 1), r.uniform(-0.3, 0.3), 0};
  return shot;
}

}  // namespace bankshot::test
