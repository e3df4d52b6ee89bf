// SPDX-License-Identifier: MIT
//
// Solves many puzzles in parallel. Threads take one puzzle at a time, so that a hard one does not delay
// the others; they share one counter and nothing else. The answers are in the order of the puzzles and,
// except for `time_us`, do not depend on the number of threads.
#pragma once

#include <span>
#include <vector>

#include "bankshot/plan/planner.hpp"

namespace bankshot {

struct BatchOptions {
  SolveOptions solve{};
  int threads = 0;  ///< 0: one per core
};

/// Returns one answer for each puzzle. Never throws for a puzzle: an exception of `solve` becomes an
/// `invalid` answer in its place.
std::vector<Answer> solve_batch(std::span<const Puzzle> puzzles, const BatchOptions& options = {});

}  // namespace bankshot
