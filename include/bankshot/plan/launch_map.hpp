// SPDX-License-Identifier: MIT
//
// Which launches make a shot, and how surely? One puzzle, asked about a grid of aims and speeds.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// The grid's cells tile the window, aim by aim from the lowest speed; a launch is the middle of its cell.
struct LaunchGrid {
  Range angle;  ///< rad, low < high; may begin below 0
  Range speed;  ///< m/s, 0 <= low < high
  int angles = 1, speeds = 1;

  Launch at(std::size_t i) const;
  std::size_t size() const { return static_cast<std::size_t>(angles) * static_cast<std::size_t>(speeds); }
};

struct LaunchMap {
  LaunchGrid grid;
  std::vector<bool> made;      ///< in the contract's sense, by any allowed cushions
  std::vector<double> chance;  ///< that it is made under the puzzle's noise, launched so
};

/// Each cell simulated once, and as many cells around the window as the noise reaches; spins of a range are not
/// searched: the launch spin is `puzzle.spin`. The chance is the sum over cells of the normal errors (as fine as the
/// cells are: let them be at most half a standard deviation). Bounds on speed and aim do not count, as for `success`.
/// `cancelled` ends it: then the rest counts as not made. Throws InvalidInput as `solve` does, and where the noise
/// reaches over more than two million cells.
LaunchMap launch_map(const Puzzle& puzzle, const LaunchGrid& grid, const std::atomic<bool>* cancelled = nullptr);

/// `{"angle": [from, to], "speed": […], "grid": [angles, speeds], "made": "0110…", "chance": […]}`: degrees, m/s, a
/// character or number a cell.
std::string to_json(const LaunchMap& map);

}  // namespace bankshot
