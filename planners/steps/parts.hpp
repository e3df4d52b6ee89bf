// SPDX-License-Identifier: MIT
//
// Parts of a target: where no line reaches its centre, aims that still reach some of it.
// Method without spin: follow a row of aims; between two neighbours that fail for different reasons may lie a
// window that is made, so bisect there; certify the middle of each window. Cost: some 30 simulations
// for each change of reason. With spin: climb to where the clearance is largest, some 100 simulations a lead.
// Guarantee: none; a window between two aims that fail alike, or between two of the row, is not seen.
#pragma once

#include <string_view>

#include "planners/proof/prove.hpp"
#include "planners/search.hpp"

namespace bankshot::planning {

/// Certifies an off-centre shot of one window inside `aims` [rad], the one nearest to `centre` first.
/// For paths whose shape does not depend on the speed.
bool reach_part(Search& s, const Range& aims, double centre, int samples, const Goal& goal, std::string_view planner);

/// The same around a lead, along its cushions, at the speed that each aim needs.
bool bisect_lead(Search& s, const Search::Lead& lead, std::string_view planner);

/// Certifies an off-centre shot around a lead, along its cushions, at the speed that each aim needs: where the
/// clearance (clearance.hpp) is largest; room.cpp. `lead.room` receives that.
bool reach_part(Search& s, Search::Lead& lead, std::string_view planner);

/// The same where the speed jumps with the aim, and where only the replay can tell which cushion comes first.
bool reach_part_thoroughly(Search& s, const Search::Lead& lead, std::string_view planner);

}  // namespace bankshot::planning
