// SPDX-License-Identifier: MIT
//
// The entry point of the planners. Every shot in an answer is verified by replay in the plain simulator:
// a planner can fail to find a shot, but it never returns a wrong one.
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
  bool all = false;          ///< return every distinct shot, not only the best
  bool first = false;        ///< return the first shot found, not the best; not with `all`
  bool robustness = true;    ///< compute margin and success; otherwise `robust` ranks by first-order margin
  bool sensitivity = false;  ///< compute how far each coefficient of the table moves each arrival
  bool suggest = true;       ///< if there is no shot, search for relaxations that allow one
  int depth = 3;             ///< number of balls that the plan of a game looks at; 1: the first shot alone; 0: no plan
  int plies = 1;             ///< pots that a shot of a game is chosen for: 1: the next; 2: also the one after it
  bool measure = false;      ///< fill Answer::cost; this reads a clock at each replay
  /// The search ends with its current result when this becomes true. Another thread may set it. It must outlive the
  /// call.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Solves one puzzle. Invalid puzzles and unknown planners throw InvalidInput; every other outcome, such as a puzzle
/// that is too hard, is a status.
Answer solve(const Puzzle& puzzle, const SolveOptions& options = {});

struct PlannerInfo {
  std::string_view name, summary;
  bool bends = true;  ///< it handles physics in which the shape of a path depends on speed; else `solve` refuses them
};
std::span<const PlannerInfo> planners();

}  // namespace bankshot
