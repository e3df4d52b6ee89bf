// SPDX-License-Identifier: MIT
//
// Which of the shots found is the answer: their order by `prefer`, margin and success where they are
// asked for, and the safest launch inside what is made.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

/// Drops shots beside the centre where some line reaches it, and orders the rest, best first.
void rank(const Search& s, std::vector<Shot>& shots);

/// Margin and success: of every shot (`all`), else of the best; success of all that compete where it
/// decides the order.
void add_robustness(Search& s, std::vector<Shot>& shots, bool all);

/// Moves a launch inside what is made to where the chance of success is largest: a compass search, one
/// success a step. The shot is replayed; its miss is no longer 0.
void make_safest(Search& s, Shot& shot);

}  // namespace bankshot::planning
