// SPDX-License-Identifier: MIT
#pragma once

#include "planners/question.hpp"

namespace bankshot::planning {

/// Fills in what each coefficient of the table moves the shot's arrival by, per unit of it: a locked simulation with
/// derivatives for each.
void add_sensitivity(const Question& q, Shot& shot);

}  // namespace bankshot::planning
