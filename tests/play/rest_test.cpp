// SPDX-License-Identifier: MIT
#include "planners/play/rest.hpp"

#include "support/catch.hpp"
#include "support/one_pot.hpp"

using namespace bankshot;
using namespace bankshot::planning;

TEST_CASE("where the cue ball rests along its branch is where the simulator leaves it, and derivatives agree") {
  test::OnePot s;
  const play::CuePath path = s.path(s.x);
  const auto rest = play::rest_of(s.request, s.budget, path, s.x, branch::Vary::spin_too);
  REQUIRE(rest);
  const Ending ending = play_out(s.request.spinning(branch::spin_of(s.x)), s.budget, branch::launch_of(s.x));
  REQUIRE(ending.cue_rests());
  CHECK(ending.traceable);
  CHECK(norm(*ending.cue_rests() - Vec2d{(*rest)[0].a, (*rest)[1].a}) < 1e-10);
  for (const int i : {branch::aim, branch::log_speed, branch::top, branch::side}) {
    constexpr double step = 1e-6;
    branch::Vector less = s.x, more = s.x;
    less[i] -= step, more[i] += step;
    const auto a = play::rest_of(s.request, s.budget, path, less, branch::Vary::launch),
               b = play::rest_of(s.request, s.budget, path, more, branch::Vary::launch);
    REQUIRE(a);
    REQUIRE(b);
    for (std::size_t k = 0; k < 2; ++k) {
      const double by = ((*b)[k].a - (*a)[k].a) / (2 * step);
      CHECK((*rest)[k].by[i] == Approx(by).epsilon(1e-4).margin(1e-4));
    }
  }
}

TEST_CASE("a launch on target is led to a place nearby, and stays on target") {
  test::OnePot s;
  const branch::Box box = branch::box_of(s.request);
  const auto from = play::on_target(s.branch, s.budget, box, s.x, 0);
  REQUIRE(from);
  const play::CuePath path = s.path(*from);
  const auto rest = play::rest_of(s.request, s.budget, path, *from, branch::Vary::launch);
  REQUIRE(rest);
  const Vec2d wanted = Vec2d{(*rest)[0].a, (*rest)[1].a} + Vec2d{0.004, 0.006};
  const auto placed = play::place(s.branch, s.budget, path, wanted, box, *from, 0, branch::Vary::spin_too);
  REQUIRE(placed);
  const auto there = play::rest_of(s.request, s.budget, path, *placed, branch::Vary::launch);
  REQUIRE(there);
  CHECK(norm(Vec2d{(*there)[0].a, (*there)[1].a} - wanted) < 1e-10);
  const auto point = branch::look(s.branch, s.budget, *placed, branch::Vary::launch);
  REQUIRE(point);
  const branch::Equations equations = play::equations_of(s.branch, *point, 0);
  for (const branch::Value& e : equations.all()) CHECK(std::abs(e.a) < 1e-11);
}

TEST_CASE("across the target a launch passes so far beside the exact line") {
  test::OnePot s;
  constexpr double shift = 0.004;
  const auto beside = play::on_target(s.branch, s.budget, branch::box_of(s.request), s.x, shift);
  REQUIRE(beside);
  const auto point = branch::look(s.branch, s.budget, *beside, branch::Vary::launch);
  REQUIRE(point);
  CHECK(point->off[0].a * s.request.problem->boundary.diagonal == Approx(shift).epsilon(1e-9));
}
