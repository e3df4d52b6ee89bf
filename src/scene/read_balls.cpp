// SPDX-License-Identifier: MIT
#include "scene/read_balls.hpp"

#include "format/shot_keys.hpp"

namespace bankshot {

Ball read_ball(const Reader& scene, Ball ball) {
  const Reader r = scene.need("ball");
  r.only(format::ball);
  ball.at = r.need("at").point();
  r.read(format::ball["radius"], ball.body.radius);
  r.read(format::ball["mass"], ball.body.mass);
  return ball;
}

std::vector<Ball> read_others(const Reader& scene, const Body& struck) {
  std::vector<Ball> others;
  const auto list = scene.find("others");
  if (!list) return others;
  for (const Reader& r : list->items()) {
    r.only(format::other);
    Ball& ball = others.emplace_back(Ball{r.need("at").point(), struck, std::string(r.need("id").text())});
    r.read(format::other["radius"], ball.body.radius);
    r.read(format::other["mass"], ball.body.mass);
  }
  return others;
}

namespace {

LaunchSpin read_spin(const Reader& r) {
  r.only(format::launch_spin);
  LaunchSpin spin;
  r.read(format::launch_spin["top"], spin.top);
  r.read(format::launch_spin["side"], spin.side);
  r.read(format::launch_spin["masse"], spin.masse);
  return spin;
}

}  // namespace

LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed) {
  if (carries_spin(physics)) return read_spin(r);
  if (printed && r.is_object()) {
    const LaunchSpin spin = read_spin(r);
    if (spin.top == 1 && spin.side == 0 && spin.masse == 0) return {};
  }
  r.fail("needs the physics \"spin\": in \"ideal\" and \"rolling\" the ball rolls from the start");
}

}  // namespace bankshot
