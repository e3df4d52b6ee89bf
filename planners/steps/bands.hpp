// SPDX-License-Identifier: MIT
//
// The aims that lead a chain on from ball to ball, at one launch speed after the other; for the step of chains.
#pragma once

#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

/// All routes of a chain that occur.
void bands(const Question& q, Ledger& ledger, Findings& found, const Objects::Chain& chain);

}  // namespace bankshot::planning::steps
