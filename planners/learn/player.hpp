// SPDX-License-Identifier: MIT
//
// The player whose attempts these were.
#pragma once

#include <span>

#include "planners/learn/evidence.hpp"

namespace bankshot::planning {

/// Marks those attempts as left out that lie too far from the others.
std::vector<PlayerError> errors_of(std::span<Evidence> evidence);

}  // namespace bankshot::planning
