// SPDX-License-Identifier: MIT
//
// Curving back.
// Why hard: A massé leaves a cushion and returns to it, so the gap has a root at 0 that must not be found again and one
// that must. A parabola that just touches a line has a double root, which rounding finds or misses.
// Conditioning of the touch: With a vertex d beyond the line the time of the hit is t* − √(2d/a), so κ is about 1/√d.
// At d = 0 it is infinite, and hit and miss differ by a jump.
// Asserted: By hand, the return after 2 vn/a. Hit or miss as the sign of d says, down to d = 1e-14 of vn²/2a. The bound
// on both sides.
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr double R = 0.028575;

/// Returns a state with velocity v and the spin whose slip is `slip`; its acceleration is −μs g slip/|slip|.
State<double> with_slip(Vec2d at, Vec2d v, Vec2d slip) { return {at, v, {(slip.y - v.y) / R, (v.x - slip.x) / R, 0}}; }

}  // namespace

TEST_CASE("a ball that leaves a cushion and curves back returns after 2 vn/a") {
  const Boundary boundary(rectangle_table(2, 1), {R});
  const SlideRoll motion;
  const double a = motion.sliding_friction * motion.g;
  for (const double vn : {1e-6, 1e-4, 1e-2, 0.3}) {
    // The slip points away from the bottom cushion, so friction pulls towards it.
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
    const double depth = 1 - (c.start.at.y - R) / turn;  // distance of the vertex beyond the line, in vn²/2a
    INFO(c.what);
    Simulator sim(boundary, motion, Mirror{0.9}, c.start);
    const Event first = sim.step();
    CHECK((first.kind == EventKind::cushion && first.contact == Contact::rail(0)) == (depth > 0));
    // The gap is rounded to a unit in the last place of R, and the square root of a small depth multiplies that error.
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
