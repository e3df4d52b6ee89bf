// SPDX-License-Identifier: MIT
#include "support/filmed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bankshot/scene/coefficients.hpp"
#include "bankshot/scene/scene.hpp"

namespace bankshot::test {

Physics random_table(Random& random, const Body& body) {
  Physics p = spin_physics(body);
  SlideRoll& cloth = std::get<SlideRoll>(p.motion);
  cloth.sliding_friction = random.uniform(0.14, 0.25);
  cloth.rolling_friction = random.uniform(0.004, 0.012);
  cloth.spinning_friction = random.uniform(0.008, 0.02);
  p.cushion = Han2005{random.uniform(1.18, 1.35) * body.radius, random.uniform(0.75, 0.92), random.uniform(0.1, 0.25)};
  return p;
}

Filmed filmed(const Physics& truth, const FilmWish& wish, Random& random) {
  Filmed out{truth, {}, {}};
  const Scene scene = preset_scene("carom-10ft");
  const Vec2d size = scene.table.highest();
  for (int i = 0; i < wish.shots; ++i) {
    ShotRequest s{.id = fmt::format("{}", i), .table = scene.table, .physics = truth, .ball = scene.ball};
    constexpr double clear = 0.1;
    s.ball.at = {random.uniform(clear, size.x - clear), random.uniform(clear, size.y - clear)};
    s.launch = {random.uniform(wish.slowest, wish.fastest), random.uniform(0, 2 * 3.14159265358979323846)};
    if (carries_spin(truth)) s.spin = {.top = random.uniform(-0.8, 1), .side = random.uniform(-0.8, 0.8)};
    s.until.time = wish.seconds;
    if (!wish.bounces) {
      s.ball.at.x = 0.3;
      s.ball.at.y = std::clamp(s.ball.at.y, 0.3, size.y - 0.3);
      s.launch = {random.uniform(0.8, 1.4), wrap_angle(random.uniform(-0.1, 0.1))};
      s.until.length = 2;
    }
    out.recordings.push_back(film(s, simulate(s), wish.camera, random));
    out.shots.push_back(s);
  }
  return out;
}

double coefficient(Physics p, const std::string& name) { return *bankshot::coefficient(p, name).at(0); }

}  // namespace bankshot::test
