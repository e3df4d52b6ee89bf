// SPDX-License-Identifier: MIT
//
// The safest launch beside a shot, compared with the intervals of aims that geometry gives.
#include "planners/evaluate/safest.hpp"

#include <algorithm>
#include <cmath>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/outcome_map.hpp"
#include "support/catch.hpp"
#include "support/proved.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

constexpr double error = 0.04;  // rad, of the aim

double below(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

/// Returns a straight pass within 0.1 m, whose cue ball would touch ball 1 on lines more than 0.04 rad to the right.
Puzzle narrowed() {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.1};
  p.arrive = Range{0.1, 5};
  p.noise = {.angle = error, .speed = 0.02, .speed_share = 0};
  const double R = p.ball.body.radius, right = 0.04;
  // The touching line leaves the ball's centre 2 R to its right, half a metre ahead.
  p.others = {
      {{0.5 + 0.5 * std::cos(right) - 2 * R * std::sin(right), 0.5 - 0.5 * std::sin(right) - 2 * R * std::cos(right)},
       p.ball.body,
       "1"}};
  return p;
}

/// Returns the probability that an aim is made: from 0.04 rad on the right to the edge of the disc on the left.
double made(double aim) { return below((std::asin(0.1) - aim) / error) - below((-0.04 - aim) / error); }

Shot shot_of(const SearchRequest& request, const Launch& launch) {
  Shot shot = test::shot_of(request, launch, Demand::off_centre);
  Work work;
  add_first_order(request, shot, work);
  return shot;
}

/// Returns the largest value of all aims and speeds, if a launch must have `least` m/s to arrive.
double largest_value(double least) {
  double best = 0;
  for (int i = 0; i < 75; ++i)
    for (int k = 0; least + 0.005 * k < 2; ++k) {
      const double aim = -0.05 + 0.002 * i, speed = least + 0.005 * k;
      best = std::max(best, made(aim) * below((speed - least) / 0.02) - cost_of(Launch{speed, aim}, {}));
    }
  return best;
}

Puzzle mirrored(Puzzle p) {
  p.others[0].at.y = 1 - p.others[0].at.y;
  return p;
}

}  // namespace

TEST_CASE("the best of an outcome map has the largest value, wherever in the made region its shot lies") {
  const double aim = GENERATE(-0.03, 0.0, 0.08), speed = GENERATE(0.8, 1.6);
  CAPTURE(aim, speed);
  const Puzzle p = narrowed();
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  const Shot shot = shot_of(request, {speed, aim < 0 ? radians(360) + aim : aim});
  const auto best = likely_launches(request, budget, shot, -1);
  REQUIRE(!best.empty());
  CHECK(std::ranges::is_sorted(best, std::greater(), [](const auto& b) { return std::round(b.value * 1e4); }));
  // The middle of the made aims is likeliest; 0.9 m ahead the ball is at the target's edge.
  const double middle = (std::asin(0.1) - 0.04) / 2, least = std::sqrt(2 * 0.01 * 9.81 * 0.9);
  CHECK(angle_difference(middle, best[0].launch.angle) == Approx(0).margin(0.2 * error));
  CHECK(best[0].value == Approx(largest_value(least)).margin(0.012));
  CHECK(budget.simulations() < 2000);
  CHECK(likely_launches(request, budget, shot, 1.1).empty());  // no value is so large
}

TEST_CASE("among fast launches the slowest is worth most, less the cost of its speed") {
  Puzzle p = narrowed();
  p.arrive = Range{0.1, 20};
  p.speed = {8, 10};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  const Shot shot = shot_of(request, {9.5, 0.05});
  const auto best = likely_launches(request, budget, shot, -1);
  REQUIRE(!best.empty());
  CHECK(best[0].launch.speed == Approx(8).epsilon(0.01));
  CHECK(best[0].value == Approx(made((std::asin(0.1) - 0.04) / 2) - 0.004 * 8).margin(0.01));
}

TEST_CASE("a mirrored shot leads to the mirror image of the safest launch") {
  const Puzzle p = narrowed(), q = mirrored(p);
  const SearchRequest request(p), other(q);
  EvaluationBudget budget(100000);
  const Shot shot = shot_of(request, {1.2, 0.05}), image = shot_of(other, {1.2, radians(360) - 0.05});
  const auto best = likely_launches(request, budget, shot, -1), seen = likely_launches(other, budget, image, -1);
  REQUIRE((!best.empty() && !seen.empty()));
  CHECK(seen[0].launch.speed == Approx(best[0].launch.speed).epsilon(1e-9));
  CHECK(angle_difference(0, seen[0].launch.angle) == Approx(-angle_difference(0, best[0].launch.angle)).margin(1e-9));
  CHECK(seen[0].value == Approx(best[0].value).epsilon(1e-9));
}

TEST_CASE("a shot is moved to its safest launch if that is worth it, and keeps its bounds") {
  Puzzle p = narrowed();
  p.speed = {0.1, 1.1};
  const SearchRequest request(p);
  EvaluationBudget budget(100000);
  Shot shot = shot_of(request, {0.8, radians(360) - 0.03});
  const Shot before = shot;
  CHECK(!make_safest(request, budget, shot, 1.1));  // no value is so large
  CHECK((shot.launch.angle == before.launch.angle && !shot.robustness.value));
  REQUIRE(make_safest(request, budget, shot));
  CHECK(shot.provenance.moved);
  CHECK(shot.verification.miss > 0);
  CHECK(p.speed.contains(shot.launch.speed));
  CHECK(*shot.robustness.success == Approx(made(angle_difference(0, shot.launch.angle))).margin(0.01));
  CHECK(*shot.robustness.success > made(-0.03) + 0.1);
  const double value = *shot.robustness.value;
  REQUIRE(make_safest(request, budget, shot));
  CHECK(*shot.robustness.value >= value);
}
