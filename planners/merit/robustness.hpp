// SPDX-License-Identifier: MIT
//
// How robust a certified shot is. Computed only when asked for or shown.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

/// Condition and first-order margin from dual numbers on the locked path: one simulation.
void first_order(const Search& s, Shot& shot);

/// `margin`: the first launch, on either side, that is not made by the same cushions; found by
/// growing steps and bisection to tolerance::margin. About 150 simulations.
void find_margin(Search& s, Shot& shot);

/// `success`: the chance that the target is made by any allowed cushions, under the player's errors;
/// success.cpp says how it is found. At most `success_samples` simulations.
inline constexpr std::size_t success_samples = 150;
void find_success(Search& s, Shot& shot);

/// b − a brought into (−π, π].
double angle_difference(double a, double b);

}  // namespace bankshot::planning
