// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/simulate/work.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Adds how far each coefficient of the table moves the shot's arrival, per unit of it. Cost: one locked simulation
/// with derivatives for each.
void add_sensitivity(const SearchRequest& request, Shot& shot, Work& work);

}  // namespace bankshot::planning
