// SPDX-License-Identifier: MIT
//
// Solves puzzles that planners once failed to solve, one per line of a file of the repository, and verifies their
// shots.
#pragma once

#include <sstream>
#include <string>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"
#include "support/replay_check.hpp"

namespace bankshot::test {

/// Returns the number of puzzles. `also(puzzle, answer)` makes further checks on each.
template <class Also>
int solve_lost_puzzles(const std::string& file, Also&& also) {
  std::istringstream lines(read_repository_file(file));
  int puzzles = 0;
  for (std::string line; std::getline(lines, line); ++puzzles) {
    CAPTURE(line);
    const Puzzle p = read_puzzle(line);
    const Answer a = solve(p, {.robustness = false, .suggest = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(check_shot(p, a.shots[0]).problem == "");
    also(p, a);
  }
  return puzzles;
}

}  // namespace bankshot::test
