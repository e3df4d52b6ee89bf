// SPDX-License-Identifier: MIT
//
// Endless bouncing.
// Why hard: A rolling ball keeps its topspin through a mirror cushion and is driven back, slower each time: infinitely
// many bounces in finite time.
// Law: Below tolerance::resting of the launch speed it stays on the cushion.
// By hand: If it rolls before it is back (1/6 ≤ e < 2/5), it returns with (2 − 5e)/7 of its speed; otherwise it returns
// with e of it.
// Conditioning: Contracting; κ of the place along the cushion is that of the slow tangential motion.
// Asserted: Those ratios, a bounded number of events, the bound.
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

ShotRequest rolling_into(double e, double degrees_ = 270) {
  ShotRequest shot = spin_shot({1, 0.3}, 1.5, degrees_, {.top = 1});
  shot.physics.cushion = Mirror{e};
  return shot;
}

}  // namespace

TEST_CASE("the speeds of return fall by (2 - 5e)/7, or by e") {
  for (const double e : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}) {
    ShotRequest shot = rolling_into(e);
    std::get<SlideRoll>(shot.physics.motion).rolling_friction = 1e-9;  // negligible on the way back
    const Trajectory t = simulate(shot);
    REQUIRE(t.end == EventKind::rest);
    REQUIRE(t.cushions > 3);
    std::vector<double> leaving;
    for (const Record& r : t.events)
      if (r.kind == EventKind::cushion) leaving.push_back(r.state.velocity.y);
    INFO("restitution " << e);
    if (e < 1.0 / 6)
      CHECK(leaving[2] / leaving[1] == Approx(e).epsilon(1e-12));
    else
      CHECK(leaving[2] / leaving[1] == Approx((2 - 5 * e) / 7).epsilon(1e-6));
  }
}

TEST_CASE("no ball bounces for ever") {
  Worst worst("endless bouncing");
  for (const double e : {0.0, 1e-12, 0.01, 0.1, 0.2, 0.3, 0.39, 0.4, 0.41})
    for (const double degrees_ : {270.0, 269.0, 240.0, 200.0, 181.0}) {
      const ShotRequest shot = rolling_into(e, degrees_);
      const Trajectory t = simulate(shot);
      INFO("restitution " << e << ", aim " << degrees_);
      CHECK(t.end == EventKind::rest);
      CHECK(t.events.size() < 200);
    }
  for (const HardCase& c : hard_cases("endless bouncing")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("without friction and with loss a ball comes to rest before its speed underflows") {
  for (const double e : {0.0, 0.1, 0.5, 0.9}) {
    const Boundary boundary(rectangle_table(2, 1), {0.03});
    Simulator sim(boundary, Rolling{.friction = 0}, Mirror{e}, State<double>{{0.7, 0.4}, {1, 0.37}});
    Event event = sim.step();
    long events = 1;
    for (; !event.final() && events < 20000; ++events, event = sim.step())
      CHECK(boundary.clearance(sim.state().at) >= -boundary.touch);
    CHECK(event.kind == EventKind::rest);
  }
}
