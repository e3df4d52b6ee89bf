// SPDX-License-Identifier: MIT
//
// Launch speeds that arrive as asked, and launches brought there: by closed forms of rolling balls, and by plays.
#include "planners/solve/speed.hpp"

#include <cmath>

#include "planners/solve/made_as_asked.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

constexpr double slowing = 2 * 0.01 * 9.81;  // m/s²; twice the deceleration of `straight`

/// Returns a puzzle with a ball that rolls straight down to the bottom rail and back up to a point.
Puzzle down_and_up(double asked) {
  Puzzle p{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {1, 1}}};
  p.target = PointTarget{{1, 1.2}, 0.01};
  p.arrive = Range{asked, asked};
  p.cushions = CushionRule::in_order({Contact::rail(0)});
  return p;
}

Branch only(const SearchRequest& request) {
  static const Route none;
  return {request, request.route ? *request.route : none, request.problem->aim_points[0]};
}

}  // namespace

TEST_CASE("a rolling ball gets the launch speed that its friction and its bounce ask for") {
  const double asked = GENERATE(0.05, 0.5, 2.0);
  const Puzzle p = down_and_up(asked);
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  const double R = p.ball.body.radius, e = restitution(p.physics).at_rest;
  const double exact = std::sqrt(slowing * (1 - R) + (asked * asked + slowing * (1.2 - R)) / (e * e));
  for (const double guess : {0.3, 1.0, 5.0}) {
    CAPTURE(asked, guess);
    CHECK(speed_near(only(request), budget, radians(270), guess).value_or(0) == Approx(exact).epsilon(1e-12));
  }
  const long before = budget.simulations();
  CHECK(speed_at(only(request), budget, radians(270), 2.2).value_or(0) == Approx(exact).epsilon(0.025));
  CHECK(budget.simulations() - before < 10);
}

TEST_CASE("a sliding ball off a rail arrives as asked in the simulator") {
  const Puzzle p = test::bank();
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  const Launch near = test::near_bank(1);
  const auto arrival = [&](double speed) {
    return test::fly(test::Aimed(p), {speed, near.angle}, p.spin, 10).passes[0].fast;
  };
  const auto rough = speed_at(only(request), budget, near.angle, 2.4);
  REQUIRE(rough);
  const auto exact = speed_near(only(request), budget, near.angle, *rough);
  REQUIRE(exact);
  CHECK(arrival(*exact) == Approx(0.5).epsilon(1e-10));
  CHECK(*rough == Approx(*exact).epsilon(0.025));
}

TEST_CASE("a ball that is to stop beside its line gets the speed that rests nearest") {
  Puzzle p = test::straight();
  p.arrive = Range{0, 0};
  const SearchRequest request(p);
  EvaluationBudget budget(1000);
  const double turned = 0.1;
  CHECK(speed_near(only(request), budget, turned, 1).value_or(0) ==
        Approx(std::sqrt(slowing * std::cos(turned))).epsilon(1e-9));
}

TEST_CASE("no speed is found where none gets there, and a fixed speed stays") {
  Puzzle p = test::straight();
  p.speed = {0.1, 0.6};  // 0.668 m/s would do
  EvaluationBudget budget(1000);
  CHECK(!speed_at(only(SearchRequest(p)), budget, 0, 1));
  const SearchRequest up(p = down_and_up(0.5));
  CHECK(!speed_near(only(up), budget, radians(90), 1));  // away from the rail
  CHECK(speed_near(only(up.launched_at(1.5)), budget, 0, 1.25) == 1.25);
  CHECK(speed_at(only(up.launched_at(1.5)), budget, 0, 1) == 1.5);
}

TEST_CASE("a launch that is made is brought to the arrival speed asked, and turns as it is told") {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.2};
  const double beside = 0.05, turn = GENERATE(0.0, 0.03, -0.03), from = GENERATE(0.7, 2.0);
  CAPTURE(turn, from);
  EvaluationBudget budget(100);
  const auto found = made_as_asked(SearchRequest(p), budget, {from, beside}, turn);
  REQUIRE(found);
  CHECK(test::fly(test::Aimed(p), found->launch, {}, 10).passes[0].fast == Approx(0.5).epsilon(1e-9));
  CHECK(found->launch.angle == Approx(beside + turn * std::log(found->launch.speed / from)));
  CHECK(found->replay.made);
  // A range of arrival speeds leads to its nearer end; a launch that arrives inside it stays.
  p.arrive = Range{0.3, 0.6};
  const auto nearer = made_as_asked(SearchRequest(p), budget, {2, 0});
  REQUIRE(nearer);
  CHECK(nearer->launch.speed == Approx(std::sqrt(0.36 + slowing)));
  CHECK(made_as_asked(SearchRequest(p), budget, {0.65, 0})->launch.speed == 0.65);
}

TEST_CASE("a launch that is not made is not brought to any speed") {
  const Puzzle p = test::straight();
  EvaluationBudget budget(100), one(1);
  CHECK(!made_as_asked(SearchRequest(p), budget, {2, 0.05}));
  CHECK(!made_as_asked(SearchRequest(p), budget, {0.3, 0}));  // it falls short
  CHECK(!made_as_asked(SearchRequest(p), one, {2, 0}));
}
