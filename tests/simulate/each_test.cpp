// SPDX-License-Identifier: MIT
//
// Checks that each of many launches of one scene runs as if it were alone, to the bit, whatever was launched before it.
#include <cmath>
#include <limits>

#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/each.hpp"
#include "support/catch.hpp"
#include "support/random_shot.hpp"

using namespace bankshot;

namespace {

bool same(const State<double>& a, const State<double>& b) {
  return a.at == b.at && a.velocity == b.velocity && a.spin.x == b.spin.x && a.spin.y == b.spin.y &&
         a.spin.z == b.spin.z;
}

bool same(const Trajectory& a, const Trajectory& b) {
  if (a.end != b.end || a.length != b.length || a.cushions != b.cushions || a.legs.size() != b.legs.size() ||
      a.events.size() != b.events.size())
    return false;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    const Record &x = a.events[i], &y = b.events[i];
    if (x.kind != y.kind || x.time != y.time || x.ball != y.ball || x.contact != y.contact || !same(x.state, y.state))
      return false;
  }
  return true;
}

/// Simulates some launches of the scene, checks each against its own run, and returns their number.
long each_as_alone(const ShotRequest& scene, Random& random) {
  std::vector<Stroke> strokes{{scene.launch, scene.spin}};
  for (int i = 0; i < 4; ++i)
    strokes.push_back({{scene.launch.speed * random.uniform(0.5, 1.5), random.uniform(0, 6.28)}, scene.spin});
  long seen = 0;
  simulate_each(scene, strokes, [&](std::size_t i, const Trajectory* t) {
    ShotRequest alone = scene;
    alone.launch = strokes[i].launch;
    REQUIRE(t);
    CHECK(same(*t, simulate(alone)));
    ++seen;
  });
  return seen;
}

}  // namespace

TEST_CASE("of many launches each is as it is alone") {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  long seen = 0;
  for (const test::ShotFamily family : test::shot_families) {
    const int draws = family == test::ShotFamily::tilted ? 2 : 30;
    for (int draw = 0; draw < draws; ++draw) {
      INFO("family " << test::name(family) << ", draw " << draw << " of seed " << seed);
      ShotRequest scene = test::random_shot(random, family);
      if (draw % 3 == 1) scene.until.length = 0.7;
      seen += each_as_alone(scene, random);
    }
  }
  ShotRequest with_others;
  const Scene pool = preset_scene("pool-9ft");
  with_others.table = pool.table, with_others.physics = pool.physics, with_others.ball = pool.ball;
  with_others.ball.at = {0.6, 0.4};
  for (const double x : {1.2, 1.26, 1.9}) with_others.others.push_back({{x, 0.6}, pool.ball.body, std::to_string(x)});
  with_others.launch = {4, 0.3};
  seen += each_as_alone(with_others, random);
  CHECK(seen == 5L * (14 * 30 + 2 + 1));
}

TEST_CASE("a launch that is none is left out, and a scene that is none is refused") {
  const Scene pool = preset_scene("pool-9ft");
  ShotRequest scene{.table = pool.table, .physics = pool.physics, .ball = pool.ball};
  scene.ball.at = {0.6, 0.4};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Stroke> strokes{{{1, 0}}, {{nan, 0}}, {{1, nan}}, {{-1, 0}}, {{2, 1}, {nan, 0, 0}}, {{2, 1}}};
  std::string made;
  simulate_each(scene, strokes, [&](std::size_t, const Trajectory* t) { made += t ? '1' : '0'; });
  CHECK(made == "100001");
  scene.ball.at = {9, 9};
  CHECK_THROWS_AS(simulate_each(scene, strokes, [](std::size_t, const Trajectory*) {}), InvalidInput);
}
