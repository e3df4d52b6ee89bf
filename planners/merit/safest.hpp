// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/shot.hpp"
#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// Moves a launch inside what is made to where the chance of success is largest: a compass search. Each step is proved,
/// with every bound of the puzzle, and costs one proof and one estimate of success, which the search is charged; where
/// the budget ends, the best so far stays. The shot's miss is no longer 0.
void make_safest(const Question& q, Ledger& ledger, Shot& shot);

}  // namespace bankshot::planning
