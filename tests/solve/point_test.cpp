// SPDX-License-Identifier: MIT
//
// A launch by its five coordinates, and the point of a branch that it is, compared with plain plays around it.
#include "planners/solve/point.hpp"

#include <array>
#include <cmath>

#include "bankshot/simulate/trajectory.hpp"
#include "planners/solve/start_at.hpp"
#include "support/bank.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/played.hpp"

using namespace bankshot;
using namespace bankshot::planning;
using namespace bankshot::planning::branch;

namespace {

constexpr double step = 1e-6;

template <class T>
std::array<T, 5> numbers_of(const State<T>& s) {
  return {s.velocity.x, s.velocity.y, s.spin.x, s.spin.y, s.spin.z};
}

/// Returns the central difference of a function of the coordinates by one of them.
template <class F>
double by_difference(const Vector& x, int i, const F& f) {
  return (f(x + step * Vector::Unit(i)) - f(x - step * Vector::Unit(i))) / (2 * step);
}

/// Returns a launch of the bank with spin about every axis.
Vector spun(double speed) { return vector_of(test::near_bank(speed), {0.3, 0.4, -0.15}); }

}  // namespace

TEST_CASE("coordinates lead back to their launch and spin") {
  const Vector x = vector_of({2.5, 1.25}, {0.5, -0.25, 0.125});
  CHECK(launch_of(x).speed == Approx(2.5));
  CHECK(launch_of(x).angle == 1.25);
  CHECK(spin_of(x) == LaunchSpin{0.5, -0.25, 0.125});
  CHECK(launch_of(vector_of({1, radians(-30)}, {})).angle == Approx(radians(330)));
}

TEST_CASE("a launch is the simulator's, and its derivatives are those of launches beside it") {
  const Puzzle p = test::bank();
  const SearchRequest request(p);
  const Vector x = spun(1.9);
  const auto plain = [&](const Vector& at) {
    return numbers_of(start_state({{}, p.table, p.physics, p.ball, {}, launch_of(at), spin_of(at), {}}));
  };
  const auto all = numbers_of(start_at<coordinates>(request, x)), launch = all;
  const auto two = numbers_of(start_at<2>(request, x));
  for (std::size_t k = 0; k < launch.size(); ++k) {
    CHECK(all[k].a == Approx(plain(x)[k]));
    for (int i = 0; i < coordinates; ++i) {
      CAPTURE(k, i);
      const double by = by_difference(x, i, [&](const Vector& at) { return plain(at)[k]; });
      CHECK(value_of<coordinates>(all[k]).by[i] == Approx(by).epsilon(1e-6).margin(1e-7));
      CHECK(value_of<2>(two[k]).by[i] == (i < 2 ? all[k].v[static_cast<std::size_t>(i)] : 0));
    }
  }
}

TEST_CASE("a point of a branch passes as the simulator plays it, and so do the launches beside it") {
  const Puzzle p = test::bank();
  const SearchRequest request(p);
  EvaluationBudget budget(2);
  const test::Aimed aimed(p);
  const Vector x = spun(1.9);
  const Branch branch{request, *request.route, request.problem->aim_points[0]};
  const auto point = look(branch, budget, x, Vary::spin_too), launch_alone = look(branch, budget, x, Vary::launch);
  REQUIRE((point && launch_alone));
  CHECK(!look(branch, budget, x, Vary::launch));  // the budget is spent
  CHECK(point->equations == 1);
  const auto pass = [&](const Vector& at) { return test::fly(aimed, launch_of(at), spin_of(at), 10).passes[0]; };
  const auto compare = [&](const Value& found, const Value& two, const auto& plain) {
    CHECK(found.a == Approx(plain(x)).margin(1e-12));
    for (int i = 0; i < coordinates; ++i) {
      CAPTURE(i);
      CHECK(found.by[i] == Approx(by_difference(x, i, plain)).epsilon(1e-5).margin(1e-6));
      CHECK(two.by[i] == Approx(i < top ? found.by[i] : 0).margin(1e-14));
    }
  };
  const double diagonal = request.problem->boundary.diagonal;
  compare(point->off[0], launch_alone->off[0], [&](const Vector& at) { return pass(at).beside / diagonal; });
  compare(point->speed2, launch_alone->speed2, [&](const Vector& at) { return pass(at).fast * pass(at).fast; });
  compare(point->time, launch_alone->time, [&](const Vector& at) { return pass(at).time; });
}

TEST_CASE("a point of a branch that rests is as far from its aim point as the simulator leaves it") {
  Puzzle p = test::bank();
  p.arrive = Range{0, 0};
  const SearchRequest request(p);
  EvaluationBudget budget(1);
  const Vector x = spun(0.9);
  const auto point = look({request, *request.route, request.problem->aim_points[0]}, budget, x, Vary::spin_too);
  REQUIRE(point);
  REQUIRE(point->equations == 2);
  const auto off = [&](const Vector& at) {
    return (request.problem->aim_points[0].at - *test::played(p, launch_of(at), spin_of(at))[0]) /
           request.problem->boundary.diagonal;
  };
  CHECK(point->off[0].a == Approx(off(x).x).margin(1e-12));
  CHECK(point->off[1].a == Approx(off(x).y).margin(1e-12));
  for (int i = 0; i < coordinates; ++i) {
    CAPTURE(i);
    CHECK(point->off[0].by[i] ==
          Approx(by_difference(x, i, [&](const Vector& at) { return off(at).x; })).epsilon(1e-5).margin(1e-6));
    CHECK(point->off[1].by[i] ==
          Approx(by_difference(x, i, [&](const Vector& at) { return off(at).y; })).epsilon(1e-5).margin(1e-6));
  }
}
