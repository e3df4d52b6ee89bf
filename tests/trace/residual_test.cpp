// SPDX-License-Identifier: MIT
//
// The residuals of a branch and their derivatives, compared with closed forms and with the plain simulator.
#include "planners/trace/residual.hpp"

#include <array>
#include <cmath>

#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "planners/trace/arrival.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/played.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

/// Returns the residuals of a launch by the plain simulator, for an asked speed of at most 1 m/s.
std::array<double, 2> by_plays(const SearchRequest& request, const Launch& launch) {
  const Puzzle& p = request.puzzle();
  const double diagonal = request.problem->boundary.diagonal;
  if (request.stop) {
    const Vec2d off = (request.problem->aim_points[0].at - *test::played(p, launch, request.spin)[0]) / diagonal;
    return {off.x, off.y};
  }
  const test::Flight flight = test::fly(test::Aimed(p), launch, request.spin, 10);
  REQUIRE(flight.count == 1);
  const double v = flight.passes[0].fast;
  return {flight.passes[0].beside / diagonal, v * v - request.asked * request.asked};
}

/// Compares the residuals of a launch, and their derivatives by its unknowns, with plays around it.
void compare(const SearchRequest& request, const Launch& launch) {
  constexpr double step = 1e-6;
  EvaluationBudget budget(10);
  const Route route = request.route.value_or(Route{});
  const auto linear = linearise({request, route, request.problem->aim_points[0]}, budget, launch);
  REQUIRE(linear);
  CHECK(budget.simulations() == 1);
  const std::size_t unknowns = request.one_unknown() ? 1 : 2;
  const auto here = by_plays(request, launch);
  for (std::size_t k = 0; k < unknowns; ++k) {
    CHECK(linear->r[k] == Approx(here[k]).margin(1e-12));
    for (std::size_t i = 0; i < unknowns; ++i) {
      CAPTURE(k, i);
      const auto moved = [&](double by) {
        return i == 0 ? Launch{launch.speed, launch.angle + by} : Launch{launch.speed * std::exp(by), launch.angle};
      };
      const double by = (by_plays(request, moved(step))[k] - by_plays(request, moved(-step))[k]) / (2 * step);
      CHECK(linear->by[k][i] == Approx(by).epsilon(1e-5).margin(1e-7));
    }
  }
}

}  // namespace

TEST_CASE("a straight pass has the residuals of the worked number, and the time of its roll") {
  const Puzzle p = test::straight();
  const SearchRequest request(p);
  EvaluationBudget budget(2);
  const Branch aim{request, {}, request.problem->aim_points[0]};
  const double a = 0.01 * 9.81, square = 1 - 2 * a;
  const auto linear = linearise(aim, budget, {1, 0});
  REQUIRE(linear);
  CHECK(linear->r[0] == Approx(0).margin(1e-15));
  CHECK(linear->r[1] == Approx(square - 0.25));
  CHECK(linear->by_aim(0) == Approx(-1 / std::sqrt(5)));
  CHECK(linear->by_speed(1) == Approx(2));
  CHECK(linear->time == Approx((1 - std::sqrt(square)) / a));
  CHECK(!linearise({request, Route{{0, Contact::rail(2)}}, aim.aim_point}, budget, {1, 0}));  // along the rail
  CHECK(!linearise(aim, budget, {1, 0}));                                                     // the budget is spent
}

TEST_CASE("residuals and their derivatives are those of plain plays") {
  Puzzle p = test::bank();
  const SearchRequest request(p);
  compare(request, test::near_bank(1.9));
  compare(request.launched_at(2.2), test::near_bank(2.2));
  p.arrive = Range{0, 0};
  compare(SearchRequest(p), test::near_bank(0.9));
  p.physics.tilt = {2e-3, -1e-3};
  compare(SearchRequest(p), test::near_bank(0.9));
}

TEST_CASE("a ball that falls beside the exact line has that offset as its residual, and its squared speed") {
  const Scene scene = preset_scene("pool-9ft");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  p.ball.at = {1.7, 0.45};
  p.target = PocketTarget{5};
  p.cushions = CushionRule::exactly(0);
  p.arrive = Range{0.8, 0.8};
  const SearchRequest request(p);
  const Vec2d way = request.problem->aim_points[0].at - p.ball.at;
  for (const double turn : {-0.005, 0.0, 0.005}) {
    CAPTURE(turn);
    compare(request, {1.5, std::atan2(way.y, way.x) + turn});
  }
}

TEST_CASE("the even square of a speed counts the metres that a ball rolls to its rest") {
  Puzzle p{.table = rectangle_table(200, 2), .physics = spin_physics(), .ball = {.at = {1, 1}}, .spin = {.top = 1}};
  std::get<SlideRoll>(p.physics.motion).rolling_friction.per_speed = GENERATE(0.0, 0.004, 0.05);
  for (const double v : {0.2, 1.0, 3.0}) {
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, {}, {v, 0}, p.spin, {}});
    CHECK(even_square(p.physics, v * v) == Approx(2 * deceleration(p.physics) * t.length));
  }
  CHECK(even_square(p.physics, -0.3) == -0.3);
}

TEST_CASE("the excess of the squared speed continues evenly where the ball rests before its aim point") {
  const Puzzle p = test::straight();
  const SearchRequest request(p);
  EvaluationBudget budget(10);
  const Branch aim{request, {}, request.problem->aim_points[0]};
  for (const double square : {0.01, 0.1, 0.1962, 0.5, 4.0})
    CHECK(*excess_speed2(aim, budget, 0, square) == Approx(square - 2 * 0.01 * 9.81 - 0.25).margin(1e-12));
}
