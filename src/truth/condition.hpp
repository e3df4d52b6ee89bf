// SPDX-License-Identifier: MIT
//
// How far a run in double may be from the truth, and how far it is (simulate/simulator.hpp, property 6).
#pragma once

#include <utility>
#include <vector>

#include "truth/run.hpp"

namespace bankshot::truth {

/// κ of the simulator's property 6 for the run in double, that of the start alone (its first term), and
/// d(position of the last event)/d(start), columns x, y, vx, vy, wx, wy, wz.
struct Condition {
  double kappa = 1, of_start = 1;
  double jacobian[2][7] = {};
  std::vector<std::pair<EventKind, Contact>> events;  ///< where not those of the run in double, it is at a tie
};
Condition condition(const Run& run);

/// A run in double held against the truth: 50 digits, and integrated impacts refined.
struct Compared {
  double error = 0;  ///< m, of the last event's position
  double unit = 0;   ///< m, 2⁻⁵³ · size · κ; where impacts are integrated, their tolerance instead of 2⁻⁵³
  double kappa = 1, of_start = 1;
  std::size_t events = 0;
  /// same: the events agree. tie: they part at two events that lie within the bound of each other, or the
  /// path in double is the exact path of a start within 1e-13 of this one, or adding derivatives, which
  /// rounds differently, already changes the events. wrong: none of these.
  enum class Order { same, tie, wrong } order = Order::same;
  double ratio() const { return unit > 0 ? error / unit : 0; }
};
Compared compare_with_truth(const Run& run);

}  // namespace bankshot::truth
