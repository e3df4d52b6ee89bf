// SPDX-License-Identifier: MIT
//
// What an answer says in words: what was found or searched, which bound binds, and what would make a shot
// possible where there is none.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

std::string message(const Search& s, const Answer& a, std::size_t found);

/// The closest miss of a search without a shot.
void add_nearest(Search& s, Answer& a);

/// Solves the puzzle with a bound loosened, cheapest first, and says which loosening opens it: more
/// speed, any aim, other counts of cushions, side spin. Empty when none of these does.
std::string what_would_open(const Puzzle& puzzle);

}  // namespace bankshot::planning
