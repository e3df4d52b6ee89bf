// SPDX-License-Identifier: MIT
//
// Functions that draw the puzzles of families.hpp; its list says what each family is.
#pragma once

#include "support/random_puzzle.hpp"

namespace bankshot::test::make {

// The puzzle leaves a quantity free, or limits the search.
Made arrive_range(Random& random, Model model, int bounces);
Made spin_range(Random& random, Model model, int bounces);
Made both_bounds(Random& random, Model model, int bounces);
Made budgets(Random& random, Model model, int bounces);

// Roots lie close to a bound, to another root or to the end of the motion.
Made slow_friction(Random& random, Model model, int bounces);
Made frozen(Random& random, Model model, int bounces);
Made rail_hugging(Random& random, Model model, int bounces);
Made hexagon(Random& random, Model model, int bounces);
Made on_line(Random& random, Model model, int bounces);

// Other balls lie on the table.
Made obstacles(Random& random, Model model, int bounces);
Made kicks(Random& random, Model model, int bounces);
Made pots(Random& random, Model model, int bounces);
Made banks(Random& random, Model model, int bounces);
Made kick_pots(Random& random, Model model, int bounces);
Made kick_banks(Random& random, Model model, int bounces);
Made sent_to_rest(Random& random, Model model, int bounces);
Made sent_past(Random& random, Model model, int bounces);
Made combinations(Random& random, Model model, int bounces);
Made caroms(Random& random, Model model, int bounces);

// Tables and coefficients lie far beyond those in use.
Made slender(Random& random, Model model, int bounces);
Made sizes(Random& random, Model model, int bounces);
Made triangles(Random& random, Model model, int bounces);
Made shapes(Random& random, Model model, int bounces);
Made edge_pockets(Random& random, Model model, int bounces);
Made extremes(Random& random, Model model, int bounces);
Made many_cushions(Random& random, Model model, int bounces);
Made fast(Random& random, Model model, int bounces);

}  // namespace bankshot::test::make
