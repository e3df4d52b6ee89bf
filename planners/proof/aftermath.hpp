// SPDX-License-Identifier: MIT
//
// What happens after the struck ball has touched its target.
#pragma once

#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// Notes of a shot that touches balls whether the struck one falls into a pocket before all rest, or else where it
/// rests. In `ideal`, where none does, only whether it falls before `ideal_cushions` more events.
void add_aftermath(const Question& q, Ledger& ledger, Shot& shot);

}  // namespace bankshot::planning
