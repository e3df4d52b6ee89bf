// SPDX-License-Identifier: MIT
//
// Paths by cushions of mathavan2010. Why hard: the impact is an equation that is integrated; at natural roll, straight
// at the cushion and where spin is used up, slips reach 0, at times two in one instant, and each is a switch that must
// not be stepped across. Conditioning: at a switch derivatives are one-sided, the map itself is continuous.
// Asserted: the bound of the simulator with the impact's tolerance in place of 2⁻⁵³, against impacts integrated
// 1e7 times finer in 50 digits.
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
