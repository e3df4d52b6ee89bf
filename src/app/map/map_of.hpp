// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/plan/planner.hpp"
#include "bankshot/plan/start_map.hpp"

namespace bankshot::app::map {

/// Solves the puzzle from each start on a grid, on all cores.
StartMap map_of(const Puzzle& puzzle, int columns, int rows, const SolveOptions& options);

}  // namespace bankshot::app::map
