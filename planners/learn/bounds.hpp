// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/problem.h>

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// m/s: slower is no launch.
inline constexpr double least_speed = 0.02;

/// Keeps a launch what a cue can do; spins stay 0 where the physics carries none.
void bound_launch(ceres::Problem& problem, Seen& seen);

}  // namespace bankshot::planning
