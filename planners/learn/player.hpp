// SPDX-License-Identifier: MIT
//
// Estimates a player's errors from attempts.
#pragma once

#include <span>

#include "planners/learn/evidence.hpp"

namespace bankshot::planning {

/// Estimates the errors, and marks attempts that lie too far from the others as left out.
std::vector<PlayerError> errors_of(std::span<Evidence> evidence);

}  // namespace bankshot::planning
