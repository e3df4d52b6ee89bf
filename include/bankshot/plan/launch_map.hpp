// SPDX-License-Identifier: MIT
//
// Maps which launches of one puzzle make the shot, and with which success, on a grid of aims and speeds.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// The cells tile the window, aim by aim from the lowest speed. A launch is the middle of its cell.
struct LaunchGrid {
  Range angle;  ///< rad, low < high; may begin below 0
  Range speed;  ///< m/s, 0 <= low < high
  int angles = 1, speeds = 1;

  Launch at(std::size_t i) const;
  std::size_t size() const { return static_cast<std::size_t>(angles) * static_cast<std::size_t>(speeds); }
};

struct LaunchMap {
  LaunchGrid grid;
  std::vector<bool> made;       ///< the launch reaches the target by any allowed cushions
  std::vector<double> success;  ///< success of this launch under the puzzle's noise
};

/// Simulates each cell once, including the cells around the window that the noise reaches. Spin ranges are not
/// searched: the launch spin is `puzzle.spin`. The success is the sum of normal error weights over made cells, so cells
/// should be at most half a standard deviation wide. Bounds on speed and aim do not count, as for `success`. When
/// `cancelled` becomes true, the remaining cells count as not made. Throws InvalidInput as `solve` does, and if the
/// noise reaches more than two million cells.
LaunchMap launch_map(const Puzzle& puzzle, const LaunchGrid& grid, const std::atomic<bool>* cancelled = nullptr);

/// Returns `{"angle": [from, to], "speed": […], "grid": [angles, speeds], "made": "0110…", "chance": […]}`: degrees,
/// m/s, one character or number per cell.
std::string to_json(const LaunchMap& map);

}  // namespace bankshot
