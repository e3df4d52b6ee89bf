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
  long budget = -1;   ///< -1: the puzzle's own
  std::string noise;  ///< name of a player; empty: the puzzle's own
  bool no_timing = false, no_robustness = false, path = false;

  SolveOptions solve_options() const;
  Puzzle read(std::string_view text) const;  ///< a puzzle with the budget and player of the flags; throws InvalidInput
  /// What decides the answers, as one would type it: an output begun with other words is another one.
  std::string words() const;
};

void add_solve_flags(CLI::App& command, SolveFlags& flags);

/// A mistyped planner or player is a usage error, told before any input is read.
void check(const SolveFlags& flags);
void check_player(const std::string& name);
/// Gives a puzzle the errors of a player; none where `name` is empty.
void set_player(Puzzle& puzzle, const std::string& name);
/// What a flag that asks for a list prints instead of an answer; empty where none does.
std::string list_asked(const SolveFlags& flags);

}  // namespace bankshot::app::solve
