// SPDX-License-Identifier: MIT
//
// The parts of a search: evaluations, the targets of a puzzle, searches in one dimension, Newton's method.
#include <cmath>
#include <limits>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/plan/planner.hpp"
#include "planners/evaluation_budget.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/solve/newton.hpp"
#include "planners/verify/replay.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;
using namespace bankshot::planning;

TEST_CASE("a budget charges paths by their bounces, and shares a budget evenly") {
  EvaluationBudget budget(100);
  budget.charge(0);
  budget.charge(31);
  CHECK(budget.simulations() == 2);
  budget.charge(64);
  CHECK(budget.simulations() == 5);
  budget.charge(32, 5);
  CHECK(budget.simulations() == 15);
  {
    const EvaluationBudget::Part part(budget, 5);  // 85 are left, so the part has 17
    budget.charge(0, 16);
    CHECK_FALSE(budget.spent());
    budget.charge(0);
    CHECK(budget.spent());
    CHECK(budget.cut());
    CHECK_FALSE(budget.exhausted());
  }
  CHECK_FALSE(budget.cut());
  CHECK(budget.ever_cut());
  {
    const EvaluationBudget::Part part(budget, 4);
    const EvaluationBudget::Part inner(budget, 2);
    CHECK(budget.left() == 8);
  }
  CHECK(budget.left() == 68);
  budget.charge(0, 68);
  {
    const EvaluationBudget::Part part(budget, 2);
    CHECK(budget.spent());
  }
  CHECK(budget.cut());
  CHECK(budget.exhausted());
}

TEST_CASE("a target's aim points: a point, one pocket, any pocket") {
  Table table = rectangle_table(2, 1);
  table.pockets = six_pockets(table, pool_7ft_mouth);
  const Boundary boundary(table, {0.02});
  const auto point = aim_points_of(PointTarget{{1, 0.5}, 0.03}, boundary);
  REQUIRE(point.size() == 1);
  CHECK(point[0].reach == 0.03);
  CHECK_FALSE(point[0].captures());
  CHECK(point[0].capture() == 0);
  const auto one = aim_points_of(PocketTarget{2}, boundary);
  REQUIRE(one.size() == 1);
  CHECK(one[0].taken_by == Contact::pocket(2));
  CHECK(one[0].at == table.pockets[2].at);
  CHECK(one[0].capture() == table.pockets[2].radius);
  CHECK(aim_points_of(PocketTarget{}, boundary).size() == 6);
  CHECK(aim_points_of(PocketTarget{9}, boundary).empty());
  Puzzle p{.table = table};
  const auto words = [&](const Target& target) {
    p.target = target;
    return target_words(p);
  };
  CHECK(words(PocketTarget{2}) == "into bottom-right");
  CHECK(words(PocketTarget{}) == "into any pocket");
  CHECK(words(PointTarget{}) == "to rest in the ring");
}

TEST_CASE("bisect closes in from either side, down to rounding") {
  for (const double way : {1.0, -1.0}) {
    double in = 0, out = way * 3;
    int asked = 0;
    bisect(
        in, out, [](double, double) { return true; }, [&](double x) { return ++asked, x * x < 2; });
    CHECK(in * way == Approx(std::sqrt(2.0)).epsilon(1e-15));
    CHECK(std::abs(out - in) < 1e-15);
    CHECK(asked < 60);
  }
}

TEST_CASE("golden sections climb to a maximum between three points") {
  struct Point {
    double x, value;
  };
  const auto f = [](double x) { return Point{x, -(x - 0.3) * (x - 0.3)}; };
  int asked = 0;
  const Point best = climb(
      f(-1), f(0.1), f(2), 1e-6, [&](double x, const Point&) { return ++asked, f(x); },
      [](const Point&, const Point&, const Point&) { return false; });
  CHECK(best.x == Approx(0.3).margin(1e-6));
  CHECK(asked < 40);
}

TEST_CASE("Newton's method returns a root of its neighbourhood, or none") {
  Puzzle p{.table = rectangle_table(2, 1), .physics = spin_physics(), .ball = {.at = {0.5, 0.5}}};
  p.target = PointTarget{{1.5, 0.3}};
  const SearchRequest request(p);
  const Route route{{0, Contact::rail(0)}};
  const Branch aim{request, route, request.problem->aim_points[0]};
  const Launch near{1.2, radians(-40)};
  EvaluationBudget budget(1000);
  const auto found = newton(aim, budget, near, settings::wide);
  REQUIRE(found);
  CHECK(budget.simulations() < 24);
  CHECK(linearise(aim, budget, *found)->size() < 1e-12);
  for (const double steps : {2.9, 3.1}) {  // it goes three steps from its start, by aim or by speed
    const Neighbourhood cell{0.01, 0.02};
    const Launch turned{found->speed, found->angle + steps * cell.step_aim},
        pushed{found->speed * std::exp(steps * cell.step_speed), found->angle};
    CHECK(newton(aim, budget, turned, cell).has_value() == (steps < cell.far));
    CHECK(newton(aim, budget, pushed, cell).has_value() == (steps < cell.far));
  }
  CHECK(!newton(aim, budget, {1.2, radians(90)}, settings::wide));
  const auto known = [](const Launch&, double, const Linear&) { return true; };
  CHECK(!newton(aim, budget, near, settings::wide, known));
}

TEST_CASE("a step is as long as its longer part in longest steps, and infinite if a part is not finite") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr Neighbourhood near{0.1, 0.5};
  CHECK(size_of({0.2, -0.5}, near) == Approx(2));
  CHECK(size_of({-0.1, 2}, near) == Approx(4));
  CHECK(size_of({0.1, 0}, near) == Approx(1));
  for (const double bad : {infinite, -infinite, none}) {
    CHECK(size_of({bad, 0.5}, near) == infinite);
    CHECK(size_of({0.1, bad}, near) == infinite);
  }
}

TEST_CASE("residuals have the derivatives that differences show") {
  test::Random random(8);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const test::Made made = test::random_puzzle(random, test::Family::uniform, test::Model::spin);
    const SearchRequest request(made.puzzle);
    EvaluationBudget budget(100);
    const Replay exact = replay(request, budget, made.launch, Goal::exactly(request, made.bounces));
    if (!exact.made) continue;
    const Route route = route_by(exact.path.cushions);
    const Branch aim{request, route, request.problem->aim_points[0]};
    constexpr double h = 1e-6;
    const auto at = linearise(aim, budget, made.launch);
    const auto turned = linearise(aim, budget, {made.launch.speed, made.launch.angle + h});
    const auto pushed = linearise(aim, budget, {made.launch.speed * std::exp(h), made.launch.angle});
    if (!at || !turned || !pushed) continue;
    for (std::size_t k = 0; k < (request.one_unknown() ? 1u : 2u); ++k) {
      const double by_aim = (turned->r[k] - at->r[k]) / h;
      CAPTURE(i, k, made.launch.angle);
      // A kink within the step spoils the difference but not the derivative, so most must agree, not all.
      checked += std::abs(by_aim - at->by_aim(k)) < 1e-3 * (1 + std::abs(by_aim));
      if (request.one_unknown()) continue;
      const double by_speed = (pushed->r[k] - at->r[k]) / h;
      checked += std::abs(by_speed - at->by_speed(k)) < 1e-3 * (1 + std::abs(by_speed));
    }
  }
  CHECK(checked > 300);
}
