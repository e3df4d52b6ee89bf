// SPDX-License-Identifier: MIT
//
// The laws that a fit may take for a table's cushions.
#pragma once

#include "bankshot/learn/fit.hpp"

namespace bankshot::planning {

/// Returns the physics with cushions of `wish.model`, and with restitution and rolling friction that depend on speed as
/// wished. Coefficients that the given cushions lack get their usual values for such a ball. Integrated impacts get the
/// tolerance of a fit.
Physics with_laws(Physics physics, const FitWish& wish, const Body& body);
/// Restores the tolerance of a simulation.
void restore_tolerance(Physics& physics);

std::string model_name(const Physics& physics);

}  // namespace bankshot::planning
