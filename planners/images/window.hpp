// SPDX-License-Identifier: MIT
//
// Windows of aims that are made: where no line reaches the target's centre, aims that still reach some of it.
// Method: follow a row of aims; between two neighbours that fail for different reasons may lie a window that is made,
// so bisect there; certify the middle of each window. Cost: some 30 simulations for each change of reason.
// Guarantee: none; a window between two aims that fail alike, or between two of the row, is not seen.
#pragma once

#include <functional>

#include "planners/findings.hpp"
#include "planners/ledger.hpp"
#include "planners/proof/replay.hpp"

namespace bankshot::planning {

/// How a row of aims is followed, and what makes a shot of one of them.
struct AimRow {
  std::function<Replay(double aim)> follow;
  std::function<bool(double aim, int bounces)> certify;
};

/// Makes a shot of one window inside `aims` [rad], the one nearest to `centre` first; `samples` aims are followed.
bool find_window(const AimRow& row, Ledger& ledger, const Range& aims, double centre, int samples);

/// The same for paths whose shape does not depend on the speed.
bool reach_part(const Question& q, Ledger& ledger, Findings& found, const Range& aims, double centre, int samples,
                const Goal& goal, std::string_view step);

}  // namespace bankshot::planning
