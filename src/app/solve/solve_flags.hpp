// SPDX-License-Identifier: MIT
//
// The flags that `solve` and `batch` share.
#pragma once

#include <string>

#include "bankshot/plan/planner.hpp"

namespace CLI {
class App;
}

namespace bankshot::app::solve {

struct SolveFlags {
  SolveOptions options;
  long budget = -1;  ///< -1: the puzzle's own
  bool no_timing = false, no_robustness = false, path = false;

  SolveOptions solve_options() const;
  Puzzle read(std::string_view text) const;  ///< a puzzle with the budget of the flags; throws InvalidInput
  /// What decides the answers, as one would type it: an output begun with other words is another one.
  std::string words() const;
};

void add_solve_flags(CLI::App& command, SolveFlags& flags);

/// A mistyped planner is a usage error, told before any input is read.
void check_planner(const std::string& wanted);
/// A line each.
std::string list_of_planners();

}  // namespace bankshot::app::solve
