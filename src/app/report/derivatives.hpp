// SPDX-License-Identifier: MIT
//
// One root along one sequence of cushions, from one seed: Newton's method with dual numbers, with differences, and a
// search without derivatives.
#pragma once

#include "app/report/sections.hpp"

namespace bankshot::app::report {

inline constexpr std::size_t derivatives_steps = 4;  ///< of the progress bar

/// Adds a row of panels and a CSV to the section of the planners. Returns what each method needs, for its conclusion.
std::string add_derivatives(const Settings& settings, Section& section, Progress& progress);

}  // namespace bankshot::app::report
