// SPDX-License-Identifier: MIT
//
// The simulators that the report compares, and the shots it gives them.
#pragma once

#include <string>
#include <vector>

#include "app/report/measure.hpp"
#include "app/report/steppers.hpp"
#include "bankshot/plan/generate.hpp"

namespace bankshot::app::report {

/// A stepping simulator over its range of steps or tolerances.
struct Series {
  std::string name;
  Scheme scheme;
  std::vector<double> steps;
};

inline constexpr const char* event_driven = "event-driven (ours)";

/// Returns every simulator but ours; fixed steps go down to `least` seconds.
std::vector<Series> stepping_series(double least);

/// Returns the table of the comparison with the ball on it, with or without pockets.
const Boundary& comparison_table(bool pockets = false);

/// A start, and a later moment [s] at which the ball still moves.
struct Timed {
  State<double> start;
  double until;
};

/// Draws a shot with random place, aim, speed and spin. `until` is half way between bounce number `cushions` and the
/// next event.
Timed timed_shot(Random& draw, const Physics& physics, int cushions);

/// Returns the state at `until` from our simulator, in double.
State<double> by_events(const Boundary& boundary, const Physics& physics, const Timed& shot);

}  // namespace bankshot::app::report
