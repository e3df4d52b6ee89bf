// SPDX-License-Identifier: MIT
//
// What an answer says in words: what was found or searched, which bound binds.
#pragma once

#include <string>

#include "bankshot/plan/answer.hpp"
#include "planners/findings.hpp"
#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// `distinct`: how many shots were found, of which the answer may hold only the best.
std::string message(const Question& q, const Ledger& ledger, const Findings& found, const Answer& a,
                    std::size_t distinct);

/// The closest miss of a search without a shot (nearest.hpp), replayed. `scan`: look beyond what the search met.
void add_nearest(const Question& q, const Findings& found, bool scan, Answer& a);

}  // namespace bankshot::planning
