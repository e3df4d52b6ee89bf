// SPDX-License-Identifier: MIT
//
// The best shot of a puzzle by brute force, which shares nothing with the planners but the simulator and the words of
// the format: all roots on a fine grid (root_map.hpp), a range of arrival speeds cut into equal steps, a range of spins
// drawn from; from the best of those a pattern search climbs in all that is free. What it returns was replayed and
// keeps every bound, so it is a lower bound of the best there is.
#pragma once

#include "support/root_map.hpp"

namespace bankshot::test {

struct Fineness {
  Grid grid{};
  int arrivals = 40;  ///< values of a range of arrival speeds, its ends included
  int spins = 40;     ///< restarts in a range of spins, each on a coarse grid
  std::uint64_t seed = 1;
};

struct ByForce {
  std::optional<Root> best{};
  std::size_t roots = 0;
  long simulations = 0;
};
ByForce best_by_force(const Puzzle& puzzle, const Fineness& fineness);

/// Where the pattern search leads from a shot of somebody else; none where brute force does not see that it is exact.
std::optional<Root> climb_from(const Puzzle& puzzle, const Fineness& fineness, const Launch& launch,
                               const LaunchSpin& spin);

/// The chance that a launch makes the target under the puzzle's noise, by so many draws of a seed.
double drawn_chance(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin, int draws, std::uint64_t seed);

}  // namespace bankshot::test
