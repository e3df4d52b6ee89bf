// SPDX-License-Identifier: MIT
//
// Tests the quality of shots and misses: first-order success against success, the winner against all competitors,
// margins on both sides of their ends, the nearest miss against a scan.
#include <algorithm>
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/margin.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/verify/replay.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

constexpr long plenty = 1L << 60;
constexpr test::Model models[] = {test::Model::ideal, test::Model::rolling, test::Model::spin};

std::vector<Shot> all_shots(const Puzzle& p) {
  return solve(p, {.all = true, .robustness = false, .suggest = false}).shots;
}

/// Returns true when the changed launch makes the shot by the same cushions.
bool made(const planning::SearchRequest& request, const Shot& shot, double turned, double pushed) {
  planning::EvaluationBudget budget(plenty);
  const Launch l{shot.launch.speed + pushed, wrap_angle(shot.launch.angle + turned)};
  return l.speed > 0 && planning::replay(request, budget, l, planning::Goal::along(shot.path.cushions)).made;
}

/// Counts the launches inside an end of the margin that are not made, plus one if the launch just beyond the end is
/// made.
int wrong_places(const planning::SearchRequest& request, const Shot& shot, std::optional<double> end,
                 const Vec2d& towards) {
  constexpr int places = 50;
  if (!end) return 0;
  int wrong = 0;
  for (int i = 0; i < places; ++i) {
    const double by = *end * (i + 0.5) / places;
    wrong += !made(request, shot, by * towards.x, by * towards.y);
  }
  const double beyond = *end * (1 + 3 * tolerance::margin) + std::copysign(tolerance::same_aim, *end);
  return wrong + made(request, shot, beyond * towards.x, beyond * towards.y);
}

int wrong_places(const planning::SearchRequest& request, const Shot& shot) {
  int wrong = 0;
  for (const auto& end : shot.robustness.margin->angle) wrong += wrong_places(request, shot, end, {1, 0});
  for (const auto& end : shot.robustness.margin->speed) wrong += wrong_places(request, shot, end, {0, 1});
  return wrong;
}

}  // namespace

TEST_CASE("a first-order chance is near success where a ball must rest") {
  test::Random random(41);
  int compared = 0, far = 0;
  while (compared < 200) {
    const Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::spin).puzzle;
    const planning::SearchRequest request(p);
    if (!request.stop) continue;
    for (Shot& shot : all_shots(p)) {
      planning::EvaluationBudget budget(plenty);
      planning::find_success(request, budget, shot);
      far += std::abs(*shot.robustness.success - shot.robustness.success_estimate) > 0.01;
      ++compared;
    }
  }
  CHECK(far <= compared / 10);  // some 6 in 100 are normal
}

TEST_CASE("a first-order chance where it is known") {
  // The ball may pass its point, 1 m ahead, at up to 30 mm, and is fast enough in nearly all cases.
  Puzzle p{.table = rectangle_table(3, 2),
           .physics = rolling_physics(),
           .ball = {.at = {0.5, 1}},
           .target = PointTarget{{1.5, 1}, 0.03},
           .cushions = CushionRule::exactly(0),
           .speed = {2, 2}};
  for (const double noise : {0.002, 0.02, 0.2}) {
    p.noise = {.angle = noise, .speed = 0.1};
    CHECK(all_shots(p).at(0).robustness.success_estimate ==
          Approx(std::erf(0.03 / noise / std::sqrt(2.0))).margin(2e-3));
  }
  // Half of all speeds are below 0.
  p.noise = {.angle = 0, .speed = 1e4};
  CHECK(all_shots(p).at(0).robustness.success_estimate == Approx(0.5).margin(2e-3));
}

TEST_CASE("the winner is the one with the largest value, and few are computed") {
  int puzzles = 0, lost = 0;
  long asked = 0, full = 0;
  for (const test::Model model : models) {
    test::Random random(43);
    for (int i = 0; i < 120; ++i) {
      const Puzzle p = test::random_puzzle(random, test::Family::uniform, model).puzzle;
      const planning::SearchRequest request(p);
      planning::SearchResult found{.shots = all_shots(p)};
      std::vector<Shot> each = found.shots;
      if (each.size() < 2) continue;
      planning::EvaluationBudget some(plenty), all(plenty);
      planning::best_first(request, some, found.shots);
      planning::add_robustness(request, some, found);
      double best = -1;
      for (Shot& shot : each) {
        planning::find_success(request, all, shot);
        planning::find_margin(request, all, shot);
        best = std::max(best, *shot.robustness.value);
      }
      lost += *found.shots.front().robustness.value < best;
      asked += some.simulations();
      full += all.simulations();
      ++puzzles;
    }
  }
  CHECK(puzzles > 60);
  CHECK(lost == 0);
  CHECK(asked < full / 2);
}

TEST_CASE("a margin jumps no launch that is not made") {
  int ends = 0;
  for (const test::Model model : models)
    for (const test::Family family : {test::Family::uniform, test::Family::convex}) {
      test::Random random(44);
      for (int i = 0; i < 25; ++i) {
        const Puzzle p = test::random_puzzle(random, family, model).puzzle;
        const planning::SearchRequest request(p);
        for (Shot& shot : all_shots(p)) {
          planning::EvaluationBudget budget(plenty);
          planning::find_margin(request, budget, shot);
          INFO("puzzle " << i << " of seed 44, model " << static_cast<int>(model) << ", " << name(family));
          CHECK(wrong_places(request, shot) == 0);
          ends += 4;
        }
      }
    }
  CHECK(ends > 1000);
}

TEST_CASE("a nearest miss is no farther than a scan of 1,000 launches, and has a condition", "[heavy]") {
  test::Random random(45);
  int misses = 0;
  for (int i = 0; i < 200; ++i) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, models[i % 3]).puzzle;
    const double aim = random.uniform(0, 6);
    p.angle = Range{aim, aim + random.log_uniform(0.01, 1)};
    const planning::SearchRequest request(p);
    const Answer a = solve(p);
    if (a.status != Status::no_shot) continue;
    INFO("puzzle " << i << " of seed 45");
    REQUIRE(a.nearest);
    ++misses;
    planning::EvaluationBudget budget(plenty);
    const planning::Goal goal = planning::Goal::of(request);
    double least = 1e300;
    for (int k = 0; k < 1000; ++k) {
      const double speed =
          request.one_unknown() || p.speed.fixed() ? request.fixed_speed() : random.uniform(p.speed.low, p.speed.high);
      const Launch l{speed, wrap_angle(random.uniform(p.angle->low, p.angle->high))};
      const planning::Replay r = planning::replay(request, budget, l, goal);
      const planning::FailureReason reason = r.failure.reason;
      const bool asked =
          r.made || reason == planning::FailureReason::missed || reason == planning::FailureReason::fell_short;
      if (asked && r.bounces() >= goal.min) least = std::min(least, r.miss);
    }
    if (least < 1e300) {
      CHECK(a.nearest->shot.verification.miss <= least);
      // A path that is nearest at its start is not moved by any error.
      if (a.nearest->shot.path.arrival.time > 0) CHECK(a.nearest->shot.verification.condition > 0);
    }
  }
  CHECK(misses > 80);
}
