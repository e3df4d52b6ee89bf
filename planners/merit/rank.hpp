// SPDX-License-Identifier: MIT
//
// Which of the shots found is the answer: their order by `prefer`, and margin and success where they are asked for.
#pragma once

#include "planners/findings.hpp"
#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// How good a shot is by `prefer`, before its success is known; larger is better.
double first_merit(const Puzzle& puzzle, const Shot& shot);

/// Drops shots beside the centre where some line reaches it, and orders the rest, best first.
void rank(const Question& q, std::vector<Shot>& shots);

/// Margin and success: of every shot where all are wanted, else of the best; success of all that compete where it
/// decides the order. What that costs is no part of the search: `ledger` is one of its own.
void add_robustness(const Question& q, Ledger& ledger, Findings& found);

}  // namespace bankshot::planning
