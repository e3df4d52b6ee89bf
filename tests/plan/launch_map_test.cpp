// SPDX-License-Identifier: MIT
//
// Compares the map of launches with what the planner says of each shot: its success, computed by other means, and that
// it is made.
#include "bankshot/plan/launch_map.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

/// Returns a grid around a launch that reaches `wide` standard deviations, with the launch in the middle of a cell.
LaunchGrid around(const Puzzle& p, const Launch& l, double wide, int cells) {
  const double angle = wide * p.noise.angle, speed = wide * p.noise.speed;
  return {{l.angle - angle, l.angle + angle}, {l.speed - speed, l.speed + speed}, cells, cells};
}

}  // namespace

TEST_CASE("the chance in the middle of a map is the success of its shot") {
  constexpr std::uint64_t seed = 17;
  test::Random random(seed);
  int shots = 0;
  for (const test::Model model : {test::Model::rolling, test::Model::spin})
    for (int i = 0; i < 30; ++i) {
      Puzzle p = test::random_puzzle(random, test::Family::uniform, model).puzzle;
      p.noise = {radians(0.02), 0.01};
      const Answer a = solve(p);
      if (a.shots.empty() || a.shots[0].launch.speed < 10 * p.noise.speed) continue;
      const LaunchMap map = launch_map(p, around(p, a.shots[0].launch, 0.5, 5));
      INFO("puzzle " << i << " of model " << static_cast<int>(model) << ", seed " << seed);
      REQUIRE(map.made.size() == 25);
      CHECK(map.made[12]);
      CHECK(map.success[12] ==
            Approx(*a.shots[0].robustness.success).margin(0.08));  // cells are a fifth of a deviation wide
      ++shots;
    }
  CHECK(shots > 40);
}

TEST_CASE("without noise a chance is 1 where it is made, and 0 elsewhere") {
  Puzzle p{.table = rectangle_table(2, 1), .physics = rolling_physics(), .ball = {.at = {0.5, 0.5}}};
  p.target = PointTarget{{1.5, 0.5}, 0.05};
  p.noise = {0, 0};
  const LaunchMap map = launch_map(p, {{radians(-4), radians(4)}, {0.4, 0.5}, 40, 30});
  REQUIRE(map.made.size() == 1200);
  int made = 0;
  for (std::size_t i = 0; i < map.made.size(); ++i) {
    made += map.made[i];
    CHECK(map.success[i] == (map.made[i] ? 1 : 0));
  }
  // A rest within 0.05 m needs v² = 2 μ g d, and an aim in a range of about 5.7 degrees.
  const double slow = std::sqrt(2 * 0.01 * 9.81 * 0.95), fast = std::sqrt(2 * 0.01 * 9.81 * 1.05);
  const double share = (fast - slow) / 0.1 * (2 * std::asin(0.05) / radians(8)) * std::acos(-1) / 4;
  CHECK(made / 1200.0 == Approx(share).epsilon(0.05));
}

TEST_CASE("a map is cancelled, and cells that the noise would reach by the million are refused") {
  const Puzzle p{.table = rectangle_table(2, 1),
                 .physics = rolling_physics(),
                 .ball = {.at = {0.5, 0.5}},
                 .target = PointTarget{{1.5, 0.5}, 0.05}};
  const std::atomic<bool> at_once{true};
  const LaunchMap map = launch_map(p, {{0, 1}, {0.1, 1}, 9, 9}, &at_once);
  CHECK(std::count(map.made.begin(), map.made.end(), true) == 0);
  CHECK_THROWS_AS(launch_map(p, {{0, 1e-9}, {0.1, 1}, 9, 9}), InvalidInput);
}
