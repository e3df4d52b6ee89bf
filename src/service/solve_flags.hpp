// SPDX-License-Identifier: MIT
//
// The options that `solve` and `batch` share, and their answers.
#pragma once

#include <string>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "service/options.hpp"

namespace bankshot::service {

struct SolveFlags {
  SolveOptions options;
  long budget = -1;   ///< -1: the puzzle's own
  long depth = 3;     ///< see SolveOptions
  long plies = 1;     ///< see SolveOptions
  std::string noise;  ///< name of a player; empty: the puzzle's own
  bool no_timing = false, no_robustness = false, path = false;

  SolveOptions solve_options() const;
  Puzzle read(std::string_view text) const;  ///< reads a puzzle, sets the flags' budget and player; throws InvalidInput
  /// Returns the flags that decide the answers, as one would type them. An output begun with other words cannot be
  /// resumed.
  std::string words() const;
};

/// Returns the options; `flags` must outlive them.
std::vector<Option> options_of(SolveFlags& flags);

/// Throws BadOption if the planner or the player is mistyped, before any input is read.
void check(const SolveFlags& flags);
void check_player(const std::string& name);
/// Gives the puzzle the errors of the player named; leaves it unchanged if `name` is empty.
void set_player(Puzzle& puzzle, const std::string& name);
/// Returns the list that a flag such as --planner list prints instead of an answer; empty if none asks for one.
std::string list_asked(const SolveFlags& flags);

/// Returns the answer as text for a person. If another aim would raise success considerably, it says so.
std::string text_of(const Puzzle& puzzle, const Answer& answer, const SolveFlags& flags);

}  // namespace bankshot::service
