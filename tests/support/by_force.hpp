// SPDX-License-Identifier: MIT
//
// Finds the best shot of a puzzle by brute force. The search shares only the simulator and the types of the format with
// the planners. It takes all roots on a fine grid (root_map.hpp), for equal steps of the arrival speed and for spins
// drawn from their ranges. A pattern search then climbs from the best of these in all free quantities. The shot it
// returns was replayed and keeps every bound, so its value is a lower bound of the best value.
#pragma once

#include "support/root_map.hpp"

namespace bankshot::test {

struct Fineness {
  Grid grid{};
  int arrivals = 40;  ///< number of arrival speeds tried in a range, its ends included
  int spins = 40;     ///< number of spins tried in a range, each on a coarse grid
  std::uint64_t seed = 1;
};

struct ByForce {
  std::optional<Root> best{};
  std::size_t roots = 0;
  long simulations = 0;
};
ByForce best_by_force(const Puzzle& puzzle, const Fineness& fineness);

/// Climbs by the pattern search from a given launch; returns none when brute force does not find that the launch is
/// exact.
std::optional<Root> climb_from(const Puzzle& puzzle, const Fineness& fineness, const Launch& launch,
                               const LaunchSpin& spin);

/// Returns the success of a launch under the puzzle's noise in aim and speed, estimated from `draws` draws.
double drawn_chance(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin, int draws, std::uint64_t seed);

}  // namespace bankshot::test
