// SPDX-License-Identifier: MIT
//
// Launches that meet a target exactly, found on a grid of aims and launch speeds; of brute force (by_force.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "support/flight.hpp"

namespace bankshot::test {

/// A launch that meets the target exactly, and keeps every bound.
struct Root {
  Launch launch{};
  LaunchSpin spin{};
  std::vector<Contact> cushions{};
  std::uint64_t route = 0;       ///< see Pass
  double arrival = 0, time = 0;  ///< m/s, s
  double merit = 0;              ///< by the puzzle's `prefer`, larger is better: -m/s, -s, or a chance
};

struct Grid {
  double aim = radians(0.02);  ///< rad
  double speed = 0.06;         ///< of the launch speed
};

/// Every launch on the grid is flown. Where the speed asked lies between two neighbours in speed and the target
/// changes sides between two neighbours in aim, by the same route, there is a root; where a route begins or ends it is
/// followed half blindly for one step. `arrivals`: ascending; 0 for a stop; ignored where the launch speed is fixed.
std::vector<Root> roots_on_grid(const Aimed& aimed, const LaunchSpin& spin, const std::vector<double>& arrivals,
                                const Grid& grid, long& simulations);

/// The root that a known one becomes with another spin or arrival speed; none where its route has none.
std::optional<Root> root_near(const Aimed& aimed, const Root& near, const LaunchSpin& spin, double arrival,
                              long& simulations);

}  // namespace bankshot::test
