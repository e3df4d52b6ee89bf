// SPDX-License-Identifier: MIT
//
// Finds launches that meet a target exactly on a grid of aims and launch speeds, for the brute force of by_force.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "support/flight.hpp"

namespace bankshot::test {

/// A launch that meets the target exactly and keeps every bound.
struct Root {
  Launch launch{};
  LaunchSpin spin{};
  std::vector<Contact> cushions{};
  std::uint64_t route = 0;       ///< see Pass
  double arrival = 0, time = 0;  ///< m/s, s
  double merit = 0;              ///< by the puzzle's `prefer`, larger is better: -m/s, -s, or success
};

struct Grid {
  double aim = radians(0.02);  ///< step of the aim [rad]
  double speed = 0.06;         ///< step of the launch speed, as a fraction of it
};

/// Simulates every launch on the grid. There is a root where two neighbours in speed enclose the arrival speed asked
/// and two neighbours in aim have the target on different sides, by the same route. Where a route begins or ends, it is
/// extrapolated by one step. `arrivals` ascend; they are 0 for a stop and ignored where the launch speed is fixed.
std::vector<Root> roots_on_grid(const Aimed& aimed, const LaunchSpin& spin, const std::vector<double>& arrivals,
                                const Grid& grid, long& simulations);

/// Follows a known root to another spin or arrival speed; returns none when its route has no root there.
std::optional<Root> root_near(const Aimed& aimed, const Root& near, const LaunchSpin& spin, double arrival,
                              long& simulations);

}  // namespace bankshot::test
