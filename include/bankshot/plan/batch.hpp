// SPDX-License-Identifier: MIT
//
// Many puzzles at once. The puzzles are handed out in small blocks to as many threads as asked, so
// that a hard one holds up nobody; threads share one counter and nothing else. The answers are in
// the order of the puzzles and do not depend on the number of threads (`time_us` does).
#pragma once

#include <span>
#include <vector>

#include "bankshot/plan/planner.hpp"

namespace bankshot {

struct BatchOptions {
  SolveOptions solve{};
  int threads = 0;  ///< 0: one for each core
};

/// One answer for each puzzle. Never throws for a puzzle: what `solve` would throw becomes an
/// `invalid` answer in its place.
std::vector<Answer> solve_batch(std::span<const Puzzle> puzzles, const BatchOptions& options = {});

}  // namespace bankshot
