// SPDX-License-Identifier: MIT
//
// The laws that a fit may take for a table's cushions.
#pragma once

#include "bankshot/learn/fit.hpp"

namespace bankshot::planning {

/// With cushions after `wish.model`, restitution and rolling friction depending on speed as wished; what the given
/// cushions do not have is usual for such a ball. Impacts that are integrated are so as exactly as a fit asks.
Physics with_laws(Physics physics, const FitWish& wish, const Body& body);
/// Back to that of a simulation.
void restore_tolerance(Physics& physics);

std::string model_name(const Physics& physics);

}  // namespace bankshot::planning
