// SPDX-License-Identifier: MIT
//
// The largest clearance beside a candidate, compared with the geometry of straight lines.
#include "planners/solve/widest.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

constexpr double within = 0.06;

/// Returns the straight puzzle with a wider target, and a ball half way whose centre lies so far below the line.
Puzzle blocked(double below) {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, within};
  p.others = {{{1, 0.5 - below}, p.ball.body, "1"}};
  return p;
}

/// Returns the largest clearance of straight lines at the point and at the ball, from many of them.
double largest_clearance(double below, double radius) {
  double best = -1;
  for (int i = -6000; i <= 6000; ++i) {
    const double aim = i * 1e-5;
    const double at_ball = std::abs(0.5 * std::sin(aim) + below * std::cos(aim)) - 2 * radius,
                 at_point = within - std::abs(std::sin(aim));
    best = std::max(best, std::min(at_ball, at_point));
  }
  return best;
}

}  // namespace

TEST_CASE("the largest clearance beside a candidate is that of geometry, and makes a shot where it is positive") {
  const double R = Body{}.radius, below = GENERATE_COPY(2 * R - 0.01, 2 * R - 0.03, 1.5 * R, 0.5 * R);
  CAPTURE(below);
  const Puzzle p = blocked(below);
  const SearchRequest request(p);
  EvaluationBudget budget(10000);
  SearchResult found;
  Candidate candidate{{std::sqrt(0.25 + 2 * 0.01 * 9.81), 0}, {}, request.problem->aim_points[0]};
  climb_clearance(request, budget, found, candidate);
  CHECK(candidate.half == Approx(within));  // a radian moves the pass by a metre
  const double most = largest_clearance(below, p.ball.body.radius);
  CHECK(candidate.room < most + 1e-6);
  CHECK(candidate.room > most - 0.15 * std::abs(most) - 1e-6);
  REQUIRE(found.shots.size() == (most > 0 ? 1 : 0));
  CHECK(budget.simulations() < 400);
  if (most < 0) return;
  const Shot& shot = found.shots[0];
  CHECK(shot.verification.off_centre);
  const test::Pass pass = test::fly(test::Aimed(p), shot.launch, {}, 10).passes[0];
  CHECK(pass.fast == Approx(0.5).epsilon(1e-9));
  CHECK(std::abs(pass.beside) < within);
  CHECK(std::abs(cross(direction(shot.launch.angle), p.others[0].at - p.ball.at)) > 2 * p.ball.body.radius);
}

TEST_CASE("a candidate that keeps its own half width is looked at no farther") {
  const double R = Body{}.radius;
  const Puzzle p = blocked(2 * R - 0.03);
  const SearchRequest request(p);
  EvaluationBudget budget(10000);
  SearchResult found;
  Candidate narrow{{std::sqrt(0.25 + 2 * 0.01 * 9.81), 0}, {}, request.problem->aim_points[0], {}, 0.02};
  climb_clearance(request, budget, found, narrow);
  CHECK(narrow.half == 0.02);
  CHECK(found.shots.empty());  // lines that clear the ball are turned by 0.06 rad
  CHECK(narrow.room == Approx(0.5 * std::sin(0.02) + (2 * R - 0.03) * std::cos(0.02) - 2 * R).epsilon(1e-3));
}
