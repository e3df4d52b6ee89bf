// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::app::simulate {

/// Returns a table of the shot with `rate` rows per second. Throws WriteError if it would have more than `most_rows`.
std::string csv_of(const ShotRequest& request, const Trajectory& t, double rate, double most_rows);

}  // namespace bankshot::app::simulate
