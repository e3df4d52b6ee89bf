// SPDX-License-Identifier: MIT
//
// The door to the planners. Every shot in an answer was replayed in the plain simulator and found
// to reach its target; a planner can fail to find a shot, never return a wrong one.
#pragma once

#include <atomic>
#include <span>
#include <string>
#include <string_view>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

struct SolveOptions {
  std::string planner = "auto";
  bool all = false;          ///< every distinct shot, not only the best
  bool first = false;        ///< the first shot found, not the best; not with `all`
  bool robustness = true;    ///< margin and success; without, `robust` ranks by first-order margin
  bool sensitivity = false;  ///< what each coefficient of the table moves each shot's arrival by
  bool suggest = true;       ///< where there is no shot, look for what would make one possible
  bool measure = false;      ///< fill Answer::cost, at the price of a clock beside each replay
  /// Ends the search, with what it has, as soon as this is true; may be set from another thread. Must outlive the call.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Never throws for a puzzle that is merely hard: invalid puzzles and unknown planners throw
/// InvalidInput, everything else is a status.
Answer solve(const Puzzle& puzzle, const SolveOptions& options = {});

struct PlannerInfo {
  std::string_view name, summary;
  bool bends =
      true;  ///< it also does physics where the shape of a path depends on its speed; else `solve` refuses them
};
std::span<const PlannerInfo> planners();

}  // namespace bankshot
