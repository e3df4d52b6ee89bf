// SPDX-License-Identifier: MIT
//
// Paths with cushions of mathavan2010.
// Why hard: The impact is an equation that is integrated. Slips reach 0 at natural roll, straight at the cushion and
// where spin is used up, sometimes two at one instant. Each is a switch that a step must not cross.
// Conditioning: At a switch the derivatives are one-sided, but the map itself is continuous.
// Asserted: The bound of the simulator with the impact's tolerance in place of 2⁻⁵³, against impacts integrated 1e7
// times finer in 50 digits.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("paths by integrated impacts keep the bound of their tolerance", "[heavy]") {
  Worst worst("integrated impacts");
  for (const HardCase& c : hard_cases("integrated impacts")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}
