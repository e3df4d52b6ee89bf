// SPDX-License-Identifier: MIT
//
// The chance of success against a long run of plain draws. By hand, at length: test_plan "[long]"
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "planners/robustness.hpp"
#include "planners/verify.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

/// The share of `draws` normal errors that is made.
double by_draws(const Puzzle& p, const Shot& shot, test::Random& random, int draws) {
  planning::Search s(p, false);
  const planning::Goal goal = planning::Goal::of(s);
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    const double r = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), turn = random.uniform(0, radians(360));
    const Launch l{shot.launch.speed + p.noise.speed * r * std::cos(turn), wrap_angle(shot.launch.angle + p.noise.angle * r * std::sin(turn))};
    made += l.speed > 0 && planning::replay(s, l, goal).made;
  }
  return static_cast<double>(made) / draws;
}

/// The largest difference over so many random puzzles of every physics.
void compare(int puzzles, int draws, double bound) {
  double worst = 0, sum = 0;
  int n = 0;
  for (const test::Model model : {test::Model::ideal, test::Model::rolling, test::Model::spin}) {
    test::Random random(31);
    for (int i = 0; i < puzzles; ++i) {
      const Puzzle p = test::random_puzzle(random, test::Family::uniform, model).puzzle;
      const Answer a = solve(p);
      if (a.shots.empty()) continue;
      const double error = std::abs(*a.shots[0].success - by_draws(p, a.shots[0], random, draws));
      worst = std::max(worst, error);
      sum += error * error;
      ++n;
      INFO("puzzle " << i << " of seed 31, model " << static_cast<int>(model) << ": success " << *a.shots[0].success << " is off by " << error);
      CHECK(error < bound);
    }
  }
  WARN("success: worst error " << worst << ", root mean square " << std::sqrt(sum / n) << ", of " << n << " shots");
}

}  // namespace

TEST_CASE("the chance of success is near a long run of draws") {
  compare(10, 10000, 0.03);  // the draws alone are off by up to 0.015
}

TEST_CASE("the chance of success is within 0.01 of 100,000 draws", "[.][long]") { compare(70, 100000, 0.01); }
