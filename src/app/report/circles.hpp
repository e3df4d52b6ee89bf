// SPDX-License-Identifier: MIT
//
// Error of success probabilities computed on tables whose pockets are plain circles: part of section 2.
#pragma once

#include "app/report/page.hpp"
#include "app/report/progress.hpp"

namespace bankshot::app::report {

struct CirclesForJaws {
  Panel panel;
  std::string csv, told;
};

inline constexpr int circle_steps = 5;  ///< of the progress bar
/// Solves random pocket puzzles on tables with circles. A player with the puzzle's noise then plays the best shots on
/// the same tables with jaws.
CirclesForJaws circles_for_jaws(int puzzles, Progress& progress);

}  // namespace bankshot::app::report
