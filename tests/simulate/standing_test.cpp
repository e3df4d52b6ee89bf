// SPDX-License-Identifier: MIT
//
// Checks that the simulator of one ball meets resting balls where and when the simulator of many balls does.
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/catch.hpp"
#include "support/random_balls.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

struct Met {
  int ball = 0;  ///< 0: none
  double time = 0;
  Vec2d at{};
};

constexpr double longest = 30;  // s

Met alone(const ShotRequest& shot) {
  const Boundary boundary(shot.table, shot.ball.body, shot.others);
  return with_physics(shot.physics, [&](const auto& motion, const auto& cushion) -> Met {
    Simulator sim(boundary, motion, cushion, start_state(shot));
    Event e = sim.step(longest);
    while (!e.final()) e = sim.step(longest - sim.time());
    return {e.kind == EventKind::ball ? e.contact.index : 0, sim.time(), sim.state().at};
  });
}

Met among(const ShotRequest& shot) {
  const Starts starts(shot);
  return with_physics(shot.physics, [&](const auto& motion, const auto& cushion) -> Met {
    ManyBalls sim(starts.balls(), motion, cushion, collisions(shot.physics));
    for (;;) {
      const BallEvent e = sim.step(longest - sim.time());
      const bool last = e.ball == 0 && e.event.final() && e.event.kind != EventKind::ball;
      if (e.event.kind == EventKind::ball) return {e.event.contact.index, sim.time(), sim.state(0).at};
      if (last || e.event.kind == EventKind::horizon) return {0, sim.time(), sim.state(0).at};
    }
  });
}

}  // namespace

TEST_CASE("one ball meets those at rest as one of many does") {
  const BallFamily family = GENERATE(BallFamily::scattered, BallFamily::sizes, BallFamily::frozen, BallFamily::drag,
                                     BallFamily::rolling, BallFamily::ideal);
  constexpr std::uint64_t seed = 3;
  int met = 0, at_once = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(seed, i);
    const ShotRequest shot = random_balls(random, family);
    const Met one = alone(shot), many = among(shot);
    CAPTURE(name(family), seed, i, one.ball, many.ball, one.time, many.time);
    REQUIRE(one.ball == many.ball);
    if (one.ball == 0) continue;
    ++met;
    at_once += one.time == 0;
    CHECK(std::abs(one.time - many.time) <= 1e-9 * (1 + many.time));
    CHECK(norm(one.at - many.at) <= 1e-9);
  }
  CHECK(met > 400);
  if (family == BallFamily::frozen) CHECK(at_once > 100);
}
