// SPDX-License-Identifier: MIT
//
// The last resort, which hardly ever finds what the steps before it did not: no guarantee, up to 20,000 simulations.
#include "planners/methods/nlopt.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

void global(const Question& q, Ledger& ledger, Findings& found) { methods::search_box(q, ledger, found, word::global); }

}  // namespace bankshot::planning::steps
