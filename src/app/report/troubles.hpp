// SPDX-License-Identifier: MIT
//
// The troubles that the seed article describes, measured against the length of a step: energy that drifts, balls that
// stick in corners, balls that pass through what should stop them.
#pragma once

#include "app/report/sections.hpp"

namespace bankshot::app::report {

inline constexpr std::size_t troubles_steps = 3;  ///< of the progress bar

/// Adds a row of panels and a CSV to the section of the simulators.
void add_troubles(const Settings& settings, Section& section, Progress& progress);

}  // namespace bankshot::app::report
