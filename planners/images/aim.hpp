// SPDX-License-Identifier: MIT
//
// From an aim to a shot where the shape of a path does not depend on its speed (`ideal`, `rolling`): a trace at unit
// speed tells what the path costs, the launch speed follows in closed form, and the launch is certified.
#pragma once

#include <optional>
#include <string_view>

#include "planners/certify.hpp"

namespace bankshot::planning {

/// The launch speed for this path: fixed, or chosen by `prefer` inside what the puzzle leaves free. None when a bound
/// forbids it; then that is counted. To rest beside the target's centre the bound itself is tried, too.
std::optional<double> launch_speed(const Question& q, Findings& found, double angle, const Trace& t,
                                   Demand demand = Demand::exact);

/// Where rounding decides at a corner or on a cushion line, aims `tolerance::nudge` away are tried as well.
bool certify_aim(const Question& q, Ledger& ledger, Findings& found, double angle, int bounces, std::string_view step,
                 Demand demand = Demand::exact);

}  // namespace bankshot::planning
