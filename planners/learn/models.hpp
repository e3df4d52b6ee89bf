// SPDX-License-Identifier: MIT
//
// The laws that a fit may take for a table's cushions.
#pragma once

#include "bankshot/learn/fit.hpp"

namespace bankshot::planning {

/// With cushions after `wish.model`, restitution and rolling friction depending on speed as wished; what the given
/// cushions do not have is usual for such a ball.
Physics with_laws(Physics physics, const FitWish& wish, const Body& body);

std::string model_name(const Physics& physics);

}  // namespace bankshot::planning
