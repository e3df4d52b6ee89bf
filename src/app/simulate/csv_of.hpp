// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::app::simulate {

/// A table of the shot, `rate` rows a second; FileError where it would have more than `most_rows`.
std::string csv_of(const ShotRequest& request, const Trajectory& t, double rate, double most_rows);

}  // namespace bankshot::app::simulate
