// SPDX-License-Identifier: MIT
//
// Targets exactly at the edge of what the speed bound reaches. Why hard: the only root lies on a bound, where
// rounding decides whether it is inside, and a search inside the bounds approaches it from one side only.
// Conditioning: d(distance)/d(speed) = 2 distance/speed, benign. By hand: a rolling ball goes v²/(2 μr g), a ball struck
// in the centre 12 v²/(49 μs g) + (5v/7)²/(2 μr g). Asserted: solved at the edge, no shot a millionth beyond it.
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

constexpr double R = 0.028575;

double reach(const Physics& physics, double v) {
  if (is_straight(physics)) return v * v / (2 * 0.01 * 9.81);
  return 12 * v * v / (49 * 0.2 * 9.81) + 25 * v * v / 49 / (2 * 0.01 * 9.81);
}

Puzzle at_distance(const Physics& physics, double share) {
  const double v = 0.4;
  const Vec2d from{0.3, 0.3}, direction_{0.8, 0.6};
  return {.table = rectangle_table(2, 1),
          .physics = physics,
          .ball = {from, R, 0.17},
          .target = PointTarget{from + direction_ * (reach(physics, v) * share), 1e-9},
          .cushions = CushionRule::exactly(0),
          .arrive = Range{0, 0},
          .speed = {0.1, v}};
}

}  // namespace

TEST_CASE("a target exactly as far as the top speed goes is reached, one a millionth further is not") {
  for (const Physics& physics : {rolling_physics(), spin_physics(R)}) {
    for (const double share : {1.0, 1 - 1e-15, 1 - 1e-12, 0.5}) {
      const Puzzle p = at_distance(physics, share);
      const Answer a = solve(p, {.robustness = false});
      INFO("share " << share << ": " << a.message);
      REQUIRE(a.status == Status::solved);
      CHECK(test::check_shot(p, a.shots.front()).problem == "");
      CHECK(a.shots.front().launch.speed <= 0.4);
    }
    CHECK(solve(at_distance(physics, 1 + 1e-6), {.robustness = false}).status == Status::no_shot);
  }
}
