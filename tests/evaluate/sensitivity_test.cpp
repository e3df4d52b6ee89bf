// SPDX-License-Identifier: MIT
//
// The sensitivity of rests to coefficients of the table, compared with closed forms of rolling balls. Other shots are
// compared with differences in tests/plan/sensitivity_test.cpp.
#include "planners/evaluate/sensitivity.hpp"

#include <cmath>
#include <string>

#include "support/catch.hpp"
#include "support/proved.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

constexpr double slowing = 2 * 0.01 * 9.81;  // m/s²; twice the deceleration of a roll

}  // namespace

TEST_CASE("a rest is as sensitive to friction and restitution as its closed form") {
  const auto of = [](const SearchRequest& request, Shot shot, const std::string& name) {
    Work work;
    add_sensitivity(request, shot, work);
    for (const Sensitivity& s : shot.robustness.sensitivity)
      if (s.coefficient == name) return s.by;
    return -1.0;
  };
  Puzzle p = test::straight();
  p.arrive = Range{0, 0};
  const SearchRequest rolls(p);
  CHECK(of(rolls, test::shot_of(rolls, {std::sqrt(slowing), 0}), "friction") ==
        Approx(1 / 0.01));  // 1 m over the friction
  // Straight down to the bottom rail and up again to a point.
  p.table = rectangle_table(2, 2);
  p.ball.at = {1, 1};
  p.target = PointTarget{{1, 0.6}, 0.01};
  p.cushions = CushionRule::exactly(1);
  const SearchRequest bounces(p);
  const double R = p.ball.body.radius, e = restitution(p.physics).at_rest, up = 0.6 - R;
  const Launch down{std::sqrt(slowing * (1 - R) + slowing * up / (e * e)), radians(270)};
  CHECK(of(bounces, test::shot_of(bounces, down), "restitution") == Approx(2 * up / e).epsilon(1e-6));
  // An object ball leaves a full hit at a half of (1 + restitution) of the speed, and rolls as its square.
  Puzzle full{.table = rectangle_table(4, 2), .physics = rolling_physics(), .ball = {.at = {0.5, 1}}};
  full.others = {{{1.5, 1}, full.ball.body, "1"}};
  const double away = 0.8;
  full.target = ObjectBallTarget{{1}, {.target = PointTarget{{1.5 + away, 1}, 0.1}}};
  full.arrive = Range{0, 0};
  full.cushions = CushionRule::exactly(0);
  const SearchRequest hits(full);
  const double b = collisions(full.physics).restitution, run = 1 - 2 * R;
  const Launch at{std::sqrt(slowing * run + slowing * away * 4 / ((1 + b) * (1 + b))), 0};
  CHECK(of(hits, test::shot_of(hits, at), "ball_ball.restitution") == Approx(2 * away / (1 + b)).epsilon(1e-6));
}
