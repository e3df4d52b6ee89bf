// SPDX-License-Identifier: MIT
//
// Grazing cushions.
// Why hard: At angle ε to the cushion the place of the bounce is gap/ε, so an error δ of the gap becomes δ/ε along the
// cushion.
// Conditioning: κ is about 1/ε, and the achievable error is 2⁻⁵³ size/ε.
// Asserted: The bound C · 2⁻⁵³ · size · κ of simulator.hpp for ε = 1e-1 ... 1e-10. By hand, a point that reaches the
// line after exactly gap/ε.
#include "bankshot/simulate/locked.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("a ball with spin that grazes a cushion stays within the bound") {
  Worst worst("grazing");
  for (const HardCase& c :
       hard_cases("grazing")) {  // the place of the bounce, and of rest, where the error is small again
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
    const Boundary boundary(c.table, {c.radius});
    CHECK(run_double({boundary, c.physics, c.start, 1}).events.back().contact == Contact::rail(0));
  }
  CHECK(worst.kappa > 1e6);  // the cases are as hard as they claim
}

TEST_CASE("a point meets the line after gap over normal speed, to rounding") {
  for (const double slope : {1e-3, 1e-9, 1e-15, 1e-100, 1e-200}) {
    const Boundary boundary(rectangle_table(2, 1), {0});
    // The point moves straight on between left and right; it meets the bottom after 0.25/slope seconds.
    const Arc<double> arc{{1, 0.25}, {1, -slope}, {0, 0}, forever};
    CHECK(time_to_line(arc, boundary.walls[0], boundary.touch) == 0.25 / slope);
  }
}
