// SPDX-License-Identifier: MIT
//
// How far off chances are on a table whose pockets are plain circles: part of section 2.
#pragma once

#include "app/report/page.hpp"
#include "app/report/progress.hpp"

namespace bankshot::app::report {

struct CirclesForJaws {
  Panel panel;
  std::string csv, told;
};

/// Random pocket puzzles on tables with circles; their best shots played by a player with their noise on the same
/// tables with jaws. Steps the progress `circle_steps` times.
inline constexpr int circle_steps = 5;
CirclesForJaws circles_for_jaws(int puzzles, Progress& progress);

}  // namespace bankshot::app::report
