// SPDX-License-Identifier: MIT
//
// From a proof to the findings: a launch that proves to be a shot is kept, once, with its derivatives; any other is
// counted under the reason why it failed.
#pragma once

#include <string_view>

#include "planners/locked/residual.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {

/// True where the launch is a shot. Of shots that differ only by bounces at the target itself, the one with fewer is
/// kept. `step` names what proposed it (planners/README.md).
bool certify(const Question& q, Ledger& ledger, Findings& found, const Launch& launch, int bounces,
             std::string_view step, Demand demand = Demand::exact);

/// One launch that arrives once.
bool same_shot(const Question& q, const Shot& known, const Shot& shot);

/// Keeps a shot that was proved, unless it is known.
void keep(const Question& q, Ledger& ledger, Findings& found, Shot shot, const Goal& goal, std::string_view step);

/// The same of a root along a route; one that something blocks is kept as a lead.
bool certify_root(const LockedAim& aim, Ledger& ledger, Findings& found, const Launch& root, std::string_view step);

/// See Shot::digits.
std::optional<int> promised_digits(const Question& q, const Shot& shot);

}  // namespace bankshot::planning
