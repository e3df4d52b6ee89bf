// SPDX-License-Identifier: MIT
//
// Curving back. Why hard: a massé leaves a cushion and returns to it: the gap has a root at 0 that must not be
// found again and one that must; and a parabola that just touches a line is a double root, found or
// missed by rounding. Conditioning of the touch: with a vertex d beyond the line the time of the hit is
// t* − √(2d/a), so κ about 1/√d; at d = 0 infinite, and hit and miss differ by a jump. Asserted: by
// hand, the return after 2 vn/a; hit or miss as the sign of d says down to d = 1e-14 of vn²/2a; the bound on both
// sides.
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr double R = 0.028575;

/// Velocity v with the spin whose slip points along `slip`: the acceleration is −μs g slip/|slip|.
State<double> with_slip(Vec2d at, Vec2d v, Vec2d slip) { return {at, v, {(slip.y - v.y) / R, (v.x - slip.x) / R, 0}}; }

}  // namespace

TEST_CASE("a ball that leaves a cushion and curves back returns after 2 vn/a") {
  const Boundary boundary(rectangle_table(2, 1), {R});
  const SlideRoll motion;
  const double a = motion.sliding_friction * motion.g;
  for (const double vn : {1e-6, 1e-4, 1e-2, 0.3}) {
    // Slip away from the bottom: friction pulls towards it.
    Simulator sim(boundary, motion, Mirror{0.8}, with_slip({1, R}, {0.1, vn}, {0, 8}));
    const Event e = sim.step();
    REQUIRE(e.kind == EventKind::cushion);
    CHECK(e.contact == Contact::rail(0));
    CHECK(sim.time() == Approx(2 * vn / a).epsilon(4e-16));
    CHECK(sim.state().at.y == Approx(R).epsilon(1e-16));
    CHECK(sim.state().velocity.y == Approx(0.8 * vn).epsilon(1e-15));
  }
}

TEST_CASE("a parabola that nearly touches a cushion line hits or misses as its vertex says") {
  Worst worst("curving");
  const SlideRoll motion;
  const double a = motion.sliding_friction * motion.g, vn = 0.25, turn = vn * vn / (2 * a);
  const Boundary boundary(rectangle_table(2, 1), {R});
  for (const HardCase& c : hard_cases("curving back")) {
    const double depth = 1 - (c.start.at.y - R) / turn;  // of vn²/2a, how far the vertex lies beyond the line
    INFO(c.what);
    Simulator sim(boundary, motion, Mirror{0.9}, c.start);
    const Event first = sim.step();
    CHECK((first.kind == EventKind::cushion && first.contact == Contact::rail(0)) == (depth > 0));
    // The gap was rounded to a unit in the last place of R, which the square root of a small depth multiplies.
    if (depth > 1e-7) CHECK(sim.time() == Approx(vn / a * (1 - std::sqrt(depth))).epsilon(1e-8));
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
  CHECK(worst.kappa > 1e4);
}

TEST_CASE("at the touch itself the ball stays inside, hit or miss") {
  const Boundary boundary(rectangle_table(2, 1), {R});
  const SlideRoll motion;
  const double vn = 0.25, turn = vn * vn / (2 * motion.sliding_friction * motion.g);
  for (int ulps = -20; ulps <= 20; ++ulps) {
    Simulator sim(boundary, motion, Mirror{0.9}, with_slip({1, R + turn + ulps * 0x1p-59}, {0.2, -vn}, {0, -8}));
    sim.step();
    const double lowest = sim.arc().position(std::min(vn / 1.962, sim.travelled())).y;
    CHECK(lowest >= R - boundary.touch);
    CHECK(boundary.clearance(sim.state().at) >= -boundary.touch);
  }
}
