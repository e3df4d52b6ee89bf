// SPDX-License-Identifier: MIT
//
// Very slow and very fast balls.
// Why hard: Tolerances in metres or metres per second would swallow a ball of 1e-6 m/s or fail at 30 m/s.
// Conditioning: None of its own, but a fast ball meets many cushions.
// Asserted: By hand, the places of rest of a ball struck in the centre, 12 v²/(49 μs g) + (5v/7)²/(2 μr g), to 4 units
// in the last place of the coordinates. The bound from 1e-6 to 30 m/s.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("a slow ball rests where the formula says, down to a hundredth of a nanometre") {
  for (const double v : {1e-6, 1e-5, 1e-3, 1e-1, 0.3}) {
    const double expected = 12 * v * v / (49 * 0.2 * 9.81) + 25 * v * v / 49 / (2 * 0.01 * 9.81);
    const Trajectory t = simulate(spin_shot({0.5, 0.5}, v, 0));
    CHECK(t.end == EventKind::rest);
    CHECK(t.cushions == 0);
    CHECK(std::abs(t.events.back().state.at.x - 0.5 - expected) <= 4 * 0x1p-53);
    CHECK(t.events.back().time == Approx(2 * v / (7 * 0.2 * 9.81) + 5 * v / 7 / (0.01 * 9.81)).epsilon(1e-15));
  }
}

TEST_CASE("from 1e-6 to 30 m/s the bound holds") {
  Worst worst("speeds");
  for (const HardCase& c : hard_cases("speeds")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}
