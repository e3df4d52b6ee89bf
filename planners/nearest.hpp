// SPDX-License-Identifier: MIT
//
// The closest miss where there is no shot: of launches inside all bounds the one that makes the bounces asked and
// passes, or rests, nearest to a mark; where none makes them, the one that ends nearest.
// Method: a grid of aims and speeds and what the search remembers, then a compass search from the best few.
// Cost: settings::nearest, some 3,500 simulations; what an answer shows is no part of the search.
#pragma once

#include "planners/findings.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

/// None where no launch is allowed; without `scan` of what the search remembers alone.
std::optional<Launch> nearest_launch(const Question& q, const Findings& found, bool scan);

}  // namespace bankshot::planning
