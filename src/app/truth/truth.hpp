// SPDX-License-Identifier: MIT
//
// The truth about a shot: the simulator itself, run in 50 decimal digits from the same double start,
// and how far a rounded run may be from it (simulate/simulator.hpp, property 6).
#pragma once

#include <string>
#include <vector>

#include "bankshot/scene/boundary.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace bankshot::truth {

/// An event; in 50 digits `rest` keeps what the doubles lose.
struct TruthEvent {
  EventKind kind;
  int index;
  double time, time_rest;  ///< s: their sum has about 32 digits
  State<double> state;     ///< right after it
  Vec2d at_rest;           ///< m: state.at + at_rest has about 32 digits
};

/// What to run and when to stop: at the last of `cushions` bounces, `events` events, `until` seconds, or at rest.
struct Run {
  const Boundary& boundary;
  const Physics& physics;
  State<double> start;
  int cushions = 1000000;
  long events = 20000;
  double until = forever;
};

struct Path {
  std::vector<TruthEvent> events;
  bool ended = false;  ///< by rest, a pocket, the time or the number of cushions
};

Path run_double(const Run& run);
Path run_truth(const Run& run);  ///< in 50 digits
/// In 25, 50 or 100 digits: to see what digits cost.
Path run_in_digits(const Run& run, int digits);

/// κ of the simulator's property 6 for the run in double, that of the start alone (its first term), and
/// d(position of the last event)/d(start), columns x, y, vx, vy, wx, wy, wz.
struct Condition {
  double kappa = 1, of_start = 1;
  double jacobian[2][7] = {};
  std::vector<int> events;  ///< kind and index of each: where they are not those of the run in double, it is at a tie
};
Condition condition(const Run& run);

/// The same Jacobian from differences in 50 digits, exact to 1e-30: no dual number is involved.
Condition truth_jacobian(const Run& run);

/// A run in double held against the truth.
struct Compared {
  double error = 0;  ///< m, of the last event's position
  double unit = 0;   ///< m, 2⁻⁵³ · size · κ
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
