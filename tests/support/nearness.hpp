// SPDX-License-Identifier: MIT
//
// How near a recorded path comes to a place: by search, slow, with nothing of the library's own geometry.
#pragma once

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::test {

/// m, of the struck ball's path up to `until` seconds; infinite without a path.
double nearest_on(const Trajectory& trajectory, const Vec2d& place, double until = forever);

}  // namespace bankshot::test
