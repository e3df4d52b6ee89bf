// SPDX-License-Identifier: MIT
//
// Compares success with a large number of plain draws. A longer run by hand: test_plan "[long]"
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/verify/replay.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

double normal(test::Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform(0, 1))) * std::cos(random.uniform(0, radians(360)));
}

/// Returns the share of draws that are made when the player also errs in spin and in the places of balls.
double by_all_draws(const Puzzle& p, const Shot& shot, test::Random& random, int draws) {
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    Puzzle moved = p;
    const auto move = [&](Vec2d& at) { at += Vec2d{normal(random), normal(random)} * p.noise.at; };
    move(moved.ball.at);
    for (Ball& other : moved.others) move(other.at);
    planning::SearchRequest request(moved);
    request.spin = shot.spin;
    request.spin.side += p.noise.side * normal(random);
    request.spin.top += p.noise.top * normal(random);
    planning::EvaluationBudget budget(2);
    const Launch l{shot.launch.speed + p.noise.speed_at(shot.launch.speed) * normal(random),
                   wrap_angle(shot.launch.angle + p.noise.angle * normal(random))};
    made += l.speed > 0 && planning::replay(request, budget, l, planning::Goal::of(request)).made;
  }
  return static_cast<double>(made) / draws;
}

/// Returns the share of `draws` normal errors of aim and speed with which the shot is made.
double by_draws(const Puzzle& p, const Shot& shot, test::Random& random, int draws) {
  const planning::SearchRequest request(p);
  planning::EvaluationBudget budget(draws + 1);
  const planning::Goal goal = planning::Goal::of(request);
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    const double r = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), turn = random.uniform(0, radians(360));
    const Launch l{shot.launch.speed + p.noise.speed_at(shot.launch.speed) * r * std::cos(turn),
                   wrap_angle(shot.launch.angle + p.noise.angle * r * std::sin(turn))};
    made += l.speed > 0 && planning::replay(request, budget, l, goal).made;
  }
  return static_cast<double>(made) / draws;
}

/// Compares the success of random puzzles of three physics with plain draws.
void compare(int puzzles, int draws, double bound, std::uint64_t seed) {
  double worst = 0, sum = 0;
  int n = 0;
  for (const test::Model model : {test::Model::ideal, test::Model::rolling, test::Model::spin}) {
    test::Random random(seed), errors(seed + 1000);
    for (int i = 0; i < puzzles; ++i) {
      const Puzzle p = test::random_puzzle(random, test::Family::uniform, model).puzzle;
      const Answer a = solve(p);
      if (a.shots.empty()) continue;
      const double error = std::abs(*a.shots[0].robustness.success - by_draws(p, a.shots[0], errors, draws));
      worst = std::max(worst, error);
      sum += error * error;
      ++n;
      INFO("puzzle " << i << " of seed " << seed << ", model " << static_cast<int>(model) << ": success "
                     << *a.shots[0].robustness.success << " is off by " << error);
      CHECK(error < bound);
    }
  }
  CHECK(n == 3 * puzzles);  // every puzzle has a shot
  WARN("success: worst error " << worst << ", root mean square " << std::sqrt(sum / n) << ", of " << n << " shots");
}

/// Returns a straight shot at a point that it may pass at up to 30 mm; the speed hardly matters.
Puzzle straight(double angle_noise, double speed_noise) {
  return {.table = rectangle_table(3, 2),
          .physics = rolling_physics(),
          .ball = {.at = {0.5, 1}},
          .target = PointTarget{{1.5, 1}, 0.03},
          .cushions = CushionRule::exactly(0),
          .speed = {2, 2},
          .noise = {.angle = angle_noise, .speed = speed_noise}};
}

double chance(const Puzzle& p) { return *solve(p).shots.at(0).robustness.success; }

}  // namespace

TEST_CASE("the chance of success is near a long run of draws") {
  compare(10, 10000, 0.02, 31);  // the draws alone are off by up to 0.015
}

TEST_CASE("the chance of success where it is known") {
  const double noise = radians(1), edge = std::asin(0.03) / noise;  // in deviations of the aim
  CHECK(chance(straight(noise, 0)) == Approx(std::erf(edge / std::sqrt(2.0))).margin(2e-3));
  CHECK(chance(straight(noise, 0.1)) == Approx(std::erf(edge / std::sqrt(2.0))).margin(2e-3));
  CHECK(chance(straight(0, 0)) == Approx(1).margin(1e-12));
  // Half of all speeds are below 0, and few of the others are too slow to arrive.
  CHECK(chance(straight(0, 1000)) == Approx(0.5).margin(2e-3));
}

TEST_CASE("the chance of success takes no more simulations than are promised") {
  test::Random random(5);
  int counted = 0;
  for (const test::Model model : {test::Model::ideal, test::Model::rolling, test::Model::spin})
    for (int i = 0; i < 40; ++i) {
      Puzzle p = test::random_puzzle(random, test::Family::convex, model, 2).puzzle;
      p.noise = {.angle = random.log_uniform(1e-4, 0.1), .speed = random.log_uniform(1e-3, 1)};
      const Answer a = solve(p, {.robustness = false});
      if (a.shots.empty()) continue;
      const planning::SearchRequest request(p);
      planning::EvaluationBudget budget(budget_of(p));
      Shot shot = a.shots[0];
      planning::find_success(request, budget, shot);
      // A line that begins before is finished; each of these needs no more than the first one's points.
      using namespace planning::settings::success;
      CHECK(budget.simulations() <= static_cast<long>(most_samples + points_on_first));
      CHECK(*shot.robustness.success >= 0);
      CHECK(*shot.robustness.success <= 1);
      ++counted;
    }
  CHECK(counted == 120);  // every puzzle has a shot
}

TEST_CASE("the chance of success is within its tolerance of 100,000 draws", "[.][long]") {
  for (const std::uint64_t seed : {31, 32, 33, 34, 35})
    compare(70, 100000, tolerance::success, test::seed_or_fresh(seed));
}

TEST_CASE("errors of spin and of places are counted as plain draws count them") {
  test::Random random(3), errors(4);
  double worst = 0;
  int n = 0;
  for (int i = 0; i < 8; ++i) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::spin, i % 3).puzzle;
    p.noise.side = i % 2 == 0 ? 0.05 : 0;
    p.noise.top = 0.05;
    p.noise.at = i % 4 < 2 ? 0.002 : 0;
    const Answer a = solve(p);
    if (a.shots.empty()) continue;
    const double error = std::abs(*a.shots[0].robustness.success - by_all_draws(p, a.shots[0], errors, 20000));
    INFO("puzzle " << i << ": " << *a.shots[0].robustness.success);
    CHECK(error < 0.015);
    worst = std::max(worst, error);
    ++n;
  }
  CHECK(n > 5);
  WARN("success under all errors: worst error " << worst << " of " << n << " shots");
}

TEST_CASE("a player who also errs in spin or places makes a shot less often") {
  Puzzle p{.table = rectangle_table(2.54, 1.27),
           .physics = spin_physics(),
           .ball = {.at = {0.635, 0.4}},
           .target = PointTarget{{1.9, 0.3}, 0.05},
           .cushions = CushionRule::exactly(2)};
  const double usual = chance(p);
  p.noise.side = 0.3;
  CHECK(chance(p) < usual - 0.01);
  p.noise.side = 0;
  p.noise.at = 0.02;
  CHECK(chance(p) < usual - 0.01);
}
