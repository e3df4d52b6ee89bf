// SPDX-License-Identifier: MIT
//
// The launch speeds at which searches over aim and speed follow paths.
#pragma once

#include <vector>

#include "planners/search_request.hpp"

namespace bankshot::planning::propose {

/// Returns the launch speeds to try, `cell` apart in ln speed. None is too slow to reach the nearest aim point, or to
/// arrive as asked.
std::vector<double> speeds_to_try(const SearchRequest& request, double cell);

}  // namespace bankshot::planning::propose
