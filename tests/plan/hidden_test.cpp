// SPDX-License-Identifier: MIT
//
// Tests from which directions a pocket's opening is hidden: it is where the opening has no gap, and a turn by the given
// angle opens one.
#include <cmath>

#include "bankshot/geometry/opening.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"
#include "planners/trace/clearance.hpp"
#include "support/catch.hpp"

using namespace bankshot;

TEST_CASE("an opening is hidden from lines that have no gap, by the turn that would give them one") {
  const Boundary boundary(make_table(*find_table_preset("pool-9ft"), false), {});
  int hidden = 0, seen = 0;
  for (const Circle& pocket : boundary.pockets)
    for (const Opening& o : openings(boundary, pocket))
      for (int i = 0; i < 720; ++i) {
        const double angle = radians(0.5 * i + 0.1);
        const auto has_gap = [&](double turn) {
          const Gap<double> gap = o.gap(direction(angle + turn), 0);
          return gap.low < gap.high;
        };
        const double sine = planning::hidden(o, direction(angle)), turn = std::asin(sine), little = radians(0.01);
        ++(sine > 0 ? hidden : seen);
        CHECK((sine == 0) == has_gap(0));
        if (sine == 0) continue;
        CHECK_FALSE((has_gap(turn - little) || has_gap(little - turn)));
        CHECK((has_gap(turn + little) || has_gap(-turn - little)));
      }
  CHECK(hidden > 1000);
  CHECK(seen > 1000);
}
