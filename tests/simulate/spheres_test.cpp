// SPDX-License-Identifier: MIT
//
// Balls are spheres on one cloth: two balls of radii a and b touch when their centres are 2 √(ab) apart in plan.
#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/random_balls.hpp"
#include "support/random_shot.hpp"

using namespace bankshot;

namespace {

/// Returns a shot with a cue ball of radius a and a ball of radius b at this distance in plan.
ShotRequest two_balls(double a, double b, double apart) {
  const Scene scene = preset_scene("pool-9ft", "rolling");
  ShotRequest shot{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  shot.ball.at = {0.6, 0.5};
  shot.ball.body.radius = a;
  shot.others = {{shot.ball.at + Vec2d{apart, 0}, {b, 0.17}, "1"}};
  return shot;
}

}  // namespace

TEST_CASE("centres of touching spheres are the sum of their radii apart in space") {
  Random r(4);
  int checked = 0;
  for (int i = 0; i < 1000; ++i, ++checked) {
    const double a = r.log_uniform(1e-3, 1), b = r.log_uniform(1e-3, 1), apart = touching_distance(a, b);
    CHECK(std::hypot(apart, a - b) == Approx(a + b).epsilon(1e-14));
    CHECK(apart == touching_distance(b, a));
    CHECK(apart <= (a + b) * (1 + 1e-15));
    REQUIRE(touching_distance(a, a) == a + a);  // to the bit
  }
  CHECK(checked == 1000);
  CHECK(touching_distance(0, 0) == 0);
}

TEST_CASE("a smaller ball may stand under the round of a larger one, and no nearer") {
  const double a = 0.028575, b = 0.02, apart = touching_distance(a, b);
  CHECK(apart < a + b - 5e-4);
  CHECK_NOTHROW(validate(two_balls(a, b, apart)));
  CHECK_NOTHROW(validate(two_balls(a, b, apart - 0.9 * tolerance::overlap)));
  try {
    validate(two_balls(a, b, apart - 1e-6));
    FAIL("they overlap");
  } catch (const InvalidInput& e) {
    CHECK(e.path == "/others/0/at");
    CHECK(std::string(e.what()).find("overlaps ball \"cue\" by 1e-06 m") != std::string::npos);
  }
}

TEST_CASE("balls of any sizes meet where spheres touch") {
  Random r(5);
  int contacts = 0, unequal = 0;
  for (int i = 0; i < 200; ++i) {
    const ShotRequest shot = test::random_balls(r, test::BallFamily::sizes);
    INFO("number " << i << " of seed 5: " << test::write_shot(shot));
    const Trajectory t = simulate(shot);
    for (const Record& e : t.events) {
      if (e.kind != EventKind::ball) continue;
      const Body &one = ball_of(shot, e.ball).body, &other = ball_of(shot, e.contact.index).body;
      CHECK(norm(e.other.at - e.state.at) == Approx(touching_distance(one, other)).margin(1e-9));
      ++contacts;
      if (one.radius != other.radius) ++unequal;
    }
  }
  CHECK(contacts > 300);
  CHECK(unequal > 200);
}

TEST_CASE("a thin cut of a smaller ball touches it by the distance of spheres, and passes it just beyond") {
  const double a = 0.028575, b = 0.0225, reach = touching_distance(a, b);
  int touched = 0;
  for (const double off : {-1e-6, 1e-6}) {
    ShotRequest shot = two_balls(a, b, 0.5);
    shot.launch = {1, std::asin((reach + off) / 0.5)};
    const Trajectory t = simulate(shot);
    const auto is_contact = [](const Record& e) { return e.kind == EventKind::ball && e.time < 1; };
    const bool met = std::ranges::any_of(t.events, is_contact);
    CHECK(met == (off < 0));
    touched += met;
  }
  CHECK(touched == 1);
}
