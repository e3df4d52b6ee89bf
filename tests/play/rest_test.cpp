// SPDX-License-Identifier: MIT
#include "planners/play/rest.hpp"

#include "bankshot/scene/json.hpp"
#include "planners/verify/aftermath.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

struct OnePot {
  Puzzle puzzle = read_puzzle(R"({"table": "pool-9ft",
    "ball": {"at": [0.635, 0.4], "spin": {"top": [-1, 1], "side": [-0.75, 0.75]}},
    "others": [{"id": "1", "at": [1.6, 0.9]}], "target": {"ball": "1", "pocket": "top-right"}, "cushions": 0,
    "leave": {"point": [1.9, 0.4]}})");
  SearchRequest request{puzzle};
  EvaluationBudget budget{100000};
  std::vector<StandingBall> standing{{1, request.problem->whole->balls()[1].boundary, puzzle.others[0].at}};
  Route hit{{0, Contact::ball(1)}};
  Branch branch{request, hit, request.problem->aim_points.front()};
  branch::Vector x = branch::vector_of({2.4, 0.49}, {0.2, 0.4, 0});

  play::CuePath path(const branch::Vector& at) {
    const SearchRequest own = request.spinning(branch::spin_of(at));
    return {play_out(own, budget, branch::launch_of(at)).cue, standing};
  }
};

}  // namespace

TEST_CASE("where the cue ball rests along its branch is where the simulator leaves it, and derivatives agree") {
  OnePot s;
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
  OnePot s;
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
  const play::TargetEquations equations = play::equations_of(s.branch, *point, 0);
  for (const branch::Value& e : equations.all()) CHECK(std::abs(e.a) < 1e-11);
}

TEST_CASE("across the target a launch passes so far beside the exact line") {
  OnePot s;
  constexpr double shift = 0.004;
  const auto beside = play::on_target(s.branch, s.budget, branch::box_of(s.request), s.x, shift);
  REQUIRE(beside);
  const auto point = branch::look(s.branch, s.budget, *beside, branch::Vary::launch);
  REQUIRE(point);
  CHECK(point->off[0].a * s.request.problem->boundary.diagonal == Approx(shift).epsilon(1e-9));
}
