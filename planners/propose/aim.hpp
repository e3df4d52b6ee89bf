// SPDX-License-Identifier: MIT
//
// Makes a shot from an aim if the shape of a path does not depend on its speed (`ideal`, `rolling`). A trace at unit
// speed gives the cost of the path, the launch speed follows in closed form, and the launch is verified.
#pragma once

#include <optional>
#include <string_view>

#include "planners/verify/certify.hpp"

namespace bankshot::planning {

/// Returns the launch speed for this path: fixed, or chosen by `prefer` within the puzzle's bounds. If a bound forbids
/// it, the failure is counted and there is none. To rest beside the target's centre, the bound itself is tried too.
std::optional<double> launch_speed(const SearchRequest& request, SearchResult& found, double angle, const Trace& t,
                                   Demand demand = Demand::exact);

/// Verifies an aim and keeps its shot. If rounding decides at a corner or on a cushion line, aims `tolerance::nudge`
/// away are tried too.
bool certify_aim(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, double angle, int bounces,
                 std::string_view step, Demand demand = Demand::exact);

}  // namespace bankshot::planning
