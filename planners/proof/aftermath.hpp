// SPDX-License-Identifier: MIT
//
// What happens after the struck ball has touched its target.
#pragma once

#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// Whether the struck ball falls into a pocket, before all balls rest. In `ideal`, where none does, before
/// `ideal_cushions` more events.
bool scratches(const Question& q, Ledger& ledger, const Launch& launch);

}  // namespace bankshot::planning
