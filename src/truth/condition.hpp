// SPDX-License-Identifier: MIT
//
// Computes the error bound of a run in double and its actual error (simulate/simulator.hpp, property 6).
#pragma once

#include <utility>
#include <vector>

#include "truth/run.hpp"

namespace bankshot::truth {

/// κ of the simulator's property 6 for the run in double, its first term (that of the start), and
/// d(position of the last event)/d(start), columns x, y, vx, vy, wx, wy, wz.
struct Condition {
  double kappa = 1, of_start = 1;
  double jacobian[2][7] = {};
  std::vector<std::pair<EventKind, Contact>> events;  ///< if not those of the run in double, the run is at a tie
};
Condition condition(const Run& run);

/// The comparison of a run in double with the truth: 50 digits, and refined integrated impacts.
struct Compared {
  double error = 0;  ///< m; error of the last event's position
  double unit = 0;   ///< m; 2⁻⁵³ · size · κ; for integrated impacts, their tolerance replaces 2⁻⁵³
  double kappa = 1, of_start = 1;
  std::size_t events = 0;
  /// same: the events agree.
  /// tie: one of these is true. The first different events lie within the bound of each other. The path in double is
  /// the exact path of a start within 1e-13 of this one. Derivatives, which change the rounding, change the events.
  /// wrong: none of these.
  enum class Order { same, tie, wrong } order = Order::same;
  double ratio() const { return unit > 0 ? error / unit : 0; }
};
Compared compare_with_truth(const Run& run);

}  // namespace bankshot::truth
