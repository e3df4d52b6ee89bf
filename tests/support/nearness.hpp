// SPDX-License-Identifier: MIT
//
// Finds how near a recorded path comes to a place by a slow search that uses none of the library's geometry.
#pragma once

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::test {

/// Returns the least distance of the cue ball's path from the place, up to `until` seconds [m]; infinite without a
/// path.
double nearest_on(const Trajectory& trajectory, const Vec2d& place, double until = forever);

}  // namespace bankshot::test
