// SPDX-License-Identifier: MIT
//
// The fixed suite of puzzles on which the report compares planners. Each puzzle is made from a shot, so it has an
// answer.
#pragma once

#include <array>
#include <vector>

#include "app/report/measure.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app::report {

/// easy: 1 or 2 cushions; medium: 3; hard: 4 or 5. Every other puzzle gives the sequence, the others the count.
enum class Level { easy, medium, hard };
inline constexpr std::array levels{Level::easy, Level::medium, Level::hard};
const char* name(Level level);

/// Returns puzzles on a 9-foot table without pockets; the ball must rest at a point, or pass through it in `ideal`.
std::vector<Puzzle> suite(const Physics& physics, Level level, int count);

}  // namespace bankshot::app::report
