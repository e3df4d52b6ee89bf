// SPDX-License-Identifier: MIT
//
// Checks random shots on random tables: the ball never leaves the table and never gains energy, and a moved table gives
// the same shot.
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

ShotRequest request_of(const test::Made& made) {
  ShotRequest r{
      .table = made.puzzle.table, .physics = made.puzzle.physics, .ball = made.puzzle.ball, .launch = made.launch};
  r.until.cushions = 12;
  return r;
}

}  // namespace

TEST_CASE("a ball never leaves the table and never gains energy") {
  for (const test::Family family : test::families)
    for (const bool ideal : {true, false}) {
      test::Random random(5);
      for (int i = 0; i < 1000; ++i) {
        const ShotRequest shot =
            request_of(test::random_puzzle(random, family, ideal ? test::Model::ideal : test::Model::rolling));
        const Boundary boundary(shot.table, shot.ball.body);
        const Trajectory t = simulate(shot);
        double before = energy(shot.ball.body, t.events.front().state);
        for (const Record& e : t.events) {
          INFO(test::name(family) << " number " << i << " of seed 5");
          REQUIRE(boundary.clearance(e.state.at) >= -2e-12 * boundary.diagonal);
          const double now = energy(shot.ball.body, e.state);
          REQUIRE(now <= before * (1 + 1e-14));
          before = now;
        }
      }
    }
}

TEST_CASE("turning and moving the table turns and moves the path") {
  test::Random random(6);
  for (int i = 0; i < 500; ++i) {
    ShotRequest a = request_of(
        test::random_puzzle(random, test::Family::convex, i % 2 == 0 ? test::Model::ideal : test::Model::rolling));
    a.until.cushions = 4;
    const double turn = random.uniform(0, 6), c = std::cos(turn), s = std::sin(turn);
    const auto move = [&](const Vec2d& p) { return Vec2d{c * p.x - s * p.y + 3, s * p.x + c * p.y - 7}; };
    ShotRequest b = a;
    for (Vec2d& v : b.table.vertices) v = move(v);
    b.ball.at = move(a.ball.at);
    b.launch.angle = wrap_angle(a.launch.angle + turn);
    const Trajectory t = simulate(a), u = simulate(b);
    REQUIRE(t.sequence() == u.sequence());
    CHECK(norm(move(t.events.back().state.at) - u.events.back().state.at) < 1e-10);
  }
}

TEST_CASE("the shape of a rolling path does not depend on the speed") {
  test::Random random(8);
  for (int i = 0; i < 500; ++i) {
    ShotRequest slow = request_of(test::random_puzzle(random, test::Family::uniform, test::Model::rolling));
    slow.until = {};
    slow.launch.speed = 0.7;
    ShotRequest fast = slow;
    fast.launch.speed = 9;
    const Trajectory t = simulate(slow), u = simulate(fast);
    REQUIRE(u.cushions >= t.cushions);
    for (std::size_t k = 1; k + 1 < t.events.size() && t.events[k].kind == EventKind::cushion; ++k)
      CHECK(norm(t.events[k].state.at - u.events[k].state.at) < 1e-11);
  }
}
