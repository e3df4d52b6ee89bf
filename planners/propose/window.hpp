// SPDX-License-Identifier: MIT
//
// Windows of made aims: if no line reaches the target's centre, some aims may still reach part of it.
// Method: follow a series of aims. Between two neighbours that fail for different reasons there may be a made window,
// so bisect there; verify the middle of each window.
// Cost: some 30 simulations for each change of reason.
// Guarantee: none. A window between two neighbours that fail alike is missed.
#pragma once

#include <functional>

#include "planners/evaluation_budget.hpp"
#include "planners/search_result.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

/// Functions that follow an aim of a series, and that verify it and keep its shot.
struct AimRow {
  std::function<Replay(double aim)> follow;
  std::function<bool(double aim, int bounces)> certify;
};

/// Makes a shot of one window inside `aims` [rad], the one nearest to `centre` first; `samples` aims are followed.
bool find_window(const AimRow& row, EvaluationBudget& budget, const Range& aims, double centre, int samples);

/// Makes a shot likewise for paths whose shape does not depend on the speed.
bool reach_part(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Range& aims,
                double centre, int samples, const Goal& goal, std::string_view step);

}  // namespace bankshot::planning
