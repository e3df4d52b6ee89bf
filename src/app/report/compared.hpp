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

/// Everything but ours; fixed steps go down to `least` seconds.
std::vector<Series> stepping_series(double least);

/// The table of the comparison, with or without pockets, and the ball on it.
const Boundary& comparison_table(bool pockets = false);

/// A start and a moment, seconds later, at which the ball still moves.
struct Timed {
  State<double> start;
  double until;
};

/// A ball with random place, aim, speed and spin; `until` is half way between the `cushions`-th bounce and what
/// follows.
Timed timed_shot(Random& draw, const Physics& physics, int cushions);

/// Ours, in double.
State<double> by_events(const Boundary& boundary, const Physics& physics, const Timed& shot);

}  // namespace bankshot::app::report
