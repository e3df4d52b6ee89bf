// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/planner.hpp"
#include "bankshot/plan/start_map.hpp"

namespace bankshot::service {

/// Solves the puzzle from each start on a grid, on all cores.
StartMap start_map(const Puzzle& puzzle, int columns, int rows, const SolveOptions& options);

}  // namespace bankshot::service
