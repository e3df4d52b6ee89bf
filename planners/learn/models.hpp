// SPDX-License-Identifier: MIT
//
// The laws that a fit may take for a table's cushions.
#pragma once

#include "bankshot/learn/fit.hpp"

namespace bankshot::planning {

/// With cushions after this model, restitution depending on speed as asked; what the given cushions do not have is
/// usual for such a ball. An empty name keeps their model.
Physics with_model(Physics physics, const std::string& model, FitWish::Bounce bounce, const Body& body);

std::string model_name(const Physics& physics);

}  // namespace bankshot::planning
