// SPDX-License-Identifier: MIT
//
// Players whose noise is known. The program stress/advise.cpp counts how often the noise lies within the intervals.
#include "bankshot/learn/advise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "bankshot/plan/generate.hpp"
#include "bankshot/scene/scene.hpp"
#include "planners/learn/evidence.hpp"
#include "support/attempts.hpp"
#include "support/catch.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

const PlayerError& of(const Advice& advice, const std::string& name) {
  const auto found = std::ranges::find(advice.errors, name, &PlayerError::name);
  INFO(name);
  REQUIRE(found != advice.errors.end());
  return *found;
}

const test::Player steady{
    {{"angle", {radians(0.2), radians(0.1)}}, {"speed", {0.06, 0.03}}, {"side", {0.05, -0.03}}, {"top", {0.04, 0.02}}}};

TEST_CASE("noise and bias of a player are within what a hundred tracked attempts can tell", "[heavy]") {
  constexpr std::uint64_t seed = 31;
  Random random(seed);
  const Advice advice = advise(attempts_of(steady, {.attempts = 100}, random));
  INFO("seed " << seed);
  REQUIRE(advice.errors.size() == 4);
  for (const auto& [name, habit] : steady.habits) {
    INFO(name);
    const PlayerError& e = of(advice, name);
    CHECK(e.sigma == Approx(habit.sigma).epsilon(0.3));  // four standard errors
    CHECK(e.sigma_interval.low < e.sigma);
    CHECK(e.sigma_interval.high > e.sigma);
    REQUIRE(e.bias_is_told);
    const double half = (e.bias_interval.high - e.bias_interval.low) / 2;
    CHECK(std::abs(e.bias - habit.bias) < 2 * half);  // four standard errors
  }
  CHECK(advice.noise.angle == of(advice, "angle").sigma);
  CHECK(advice.noise.top == of(advice, "top").sigma);
  CHECK(of(advice, "speed").bias_interval.low > 0);  // too hard, with confidence
  CHECK_THAT(message_of(advice), Catch::Contains("% too hard on average"));
}

TEST_CASE("what an inexact track errs is not the player's") {
  Random random(32);
  test::Player machine = steady;
  for (auto& [name, habit] : machine.habits) habit = {1e-9, 0};
  const Advice advice = advise(attempts_of(machine, {.attempts = 40}, random));
  // The tracks alone scatter by 0.1 degrees and 0.005 m/s.
  CHECK(advice.noise.angle < radians(0.05));
  CHECK(advice.noise.speed < 0.004);
}

// Side spin that dies before the next cushion leaves no trace, and a fit that is led there stays there. The aim then
// absorbs the effect of the side spin at the cushion and claims a tenth of that error. Such attempts would make a
// player's aim seem too wild.
TEST_CASE("an attempt claims no more of its launch than its track tells", "[heavy]") {
  constexpr std::uint64_t seed = 36;
  constexpr int attempts = 200;
  Random random(seed);
  test::Player same = steady;  // has the same error in every attempt, so that each error is known
  for (auto& [name, habit] : same.habits) habit.sigma = 1e-9;
  same.habits["side"].bias = 0.06;
  planning::Spent work;
  int told = 0, too_far = 0;
  for (const Attempt& attempt : attempts_of(same, {.attempts = attempts}, random)) {
    const planning::Evidence e = planning::evidence_of(attempt, 2e-3, work);
    if (e.error.left_out) continue;
    const auto bias = [&](const char* name) { return same.habits[name].bias; };
    const planning::LaunchError truth =
        planning::LaunchError{bias("angle"), bias("speed") * e.meant_speed, bias("side"), bias("top")}.cwiseQuotient(
            planning::usual_error());
    const planning::LaunchError left = e.gradient - e.information * truth;
    constexpr double quantile = 18.47;  // 99.9 % of χ² with four degrees of freedom
    ++told, too_far += left.dot(e.information.completeOrthogonalDecomposition().solve(left)) > quantile;
  }
  INFO("seed " << seed << ": " << too_far << " of " << told);
  CHECK(told > attempts * 9 / 10);
  constexpr int few = 25;  // one in 25, because the likelihood has other kinks, and some estimates stop at one
  CHECK(too_far * few <= told);
}

// These attempts constrain the side spin only by a slope, which must not make its estimated error enormous.
TEST_CASE("attempts that hardly tell a number make it no larger") {
  constexpr std::uint64_t seed = 1, number = 191;
  Random random(seed, number);
  const test::Player player = random_player(random);
  const Advice advice = advise(attempts_of(player, {}, random));
  for (const auto& [name, habit] : player.habits) {
    INFO(name);
    CHECK(of(advice, name).sigma == Approx(habit.sigma).epsilon(0.5));
  }
}

TEST_CASE("a miscue is left out and told") {
  Random random(33);
  auto attempts = attempts_of(steady, {.attempts = 40}, random);
  const Advice before = advise(attempts);
  test::Player clumsy = steady;
  clumsy.habits["speed"].bias = -0.4;
  attempts[7] = attempts_of(clumsy, {.attempts = 1}, random).front();
  const Advice after = advise(attempts);
  const auto left_out = [](const Advice& a) { return std::ranges::count(a.attempts, true, &AttemptError::left_out); };
  CHECK_FALSE(before.attempts[7].left_out);
  CHECK(after.attempts[7].left_out);
  CHECK(left_out(after) == left_out(before) + 1);
  CHECK(after.noise.speed == Approx(before.noise.speed).epsilon(0.1));
  CHECK_THAT(message_of(after), Catch::Contains("of them left out"));
}

TEST_CASE("where balls came to rest tells something, and whether they fell a little", "[heavy]") {
  Random random(34);
  const Advice rests = advise(attempts_of(steady, {.attempts = 60, .rests_only = true}, random));
  CHECK(rests.noise.speed == Approx(steady.habits.at("speed").sigma).epsilon(0.5));
  test::Player good = steady, bad = steady;
  for (auto* player : {&good, &bad})
    for (auto& [name, habit] : player->habits) habit = {name == "speed" ? 0.06 : 0.0, 0};
  good.habits["angle"].sigma = radians(0.03), bad.habits["angle"].sigma = radians(0.6);
  const Advice of_good = advise(attempts_of(good, {.attempts = 60, .made_only = true}, random));
  const Advice of_bad = advise(attempts_of(bad, {.attempts = 60, .made_only = true}, random));
  CHECK(of_good.noise.angle * 2 < of_bad.noise.angle);
  CHECK_FALSE(of(of_bad, "angle").bias_is_told);
  CHECK(of_bad.errors.size() == 2);
}

TEST_CASE("choices are made by the player's own noise, and are no worse by it than the usual ones", "[heavy]") {
  Random random(35);
  test::Player wild = steady;
  wild.habits["angle"].sigma = radians(0.5);
  const auto attempts = attempts_of(wild, {.attempts = 40}, random);
  const Scene scene = preset_scene("pool-9ft");
  std::vector<Puzzle> puzzles;
  for (int i = 0; i < 6; ++i)
    puzzles.push_back(
        generate({.table = scene.table, .physics = scene.physics, .ball = scene.ball}, random).value().puzzle);
  const Advice advice = advise(attempts, {.shots = puzzles});
  REQUIRE(advice.shots.size() == 6);
  for (const Choice& c : advice.shots) {
    CHECK(c.solved);
    CHECK(c.success >= c.success_of_usual);
  }
  CHECK(std::ranges::is_sorted(advice.shots, std::ranges::greater{}, &Choice::success));
  CHECK(advice.gain_by_shot >= 0);
  CHECK(advice.gain_by_puzzle >= 0);
  CHECK(to_json(advise(attempts, {.shots = puzzles, .threads = 2})) == to_json(advice));
}

}  // namespace
