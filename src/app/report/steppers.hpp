// SPDX-License-Identifier: MIT
//
// Simulators that step through time, to compare with ours. They integrate the forces of motion/rolling.hpp and
// motion/slide_roll.hpp and use the same contact laws, on rectangles with or without pockets.
//   euler           the seed article's: x += v h, v += a h; a ball found behind a cushion is put on its line
//                   and bounces there ("clamped")
//   semi_implicit   v += a h first, then x += v h
//   rk4             the classical Runge–Kutta method of order four
//   dormand_prince  order five, adaptive, with dense output (Boost.Odeint)
// With `locate` a step ends exactly where the ball meets a cushion, enters a pocket, or ends its slide or roll.
// Dormand–Prince always locates events, on its dense output. Without `locate` the event is handled at the end of its
// step.
// Inside a phase û and v̂ are those of its beginning. This is exact, and continues the forces smoothly beyond the
// phase's end. The vertical spin, linear in time, is never integrated.
// Order of convergence on motion that none of them integrates exactly (tests/app/steppers_test.cpp): 1, 1, 4, 5 with
// events located, else 1. An event that begins and ends inside one step is not seen.
#pragma once

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/physics.hpp"

namespace bankshot::app::report {

struct Scheme {
  enum class Method { euler, semi_implicit, rk4, dormand_prince } method;
  bool locate = false;
  double step = 1e-3;  ///< s; for dormand_prince the tolerance, absolute and relative
  double longest = 0;  ///< s; longest step of dormand_prince, 0: any
};

struct Stepped {
  State<double> state;
  double time = 0;  ///< s; less than asked if the ball rests or is pocketed
  long steps = 0;
  int cushions = 0;
  bool pocketed = false, rests = false;
};

/// Steps until `until` seconds, rest or a pocket. `physics` must be `rolling` or `spin`.
Stepped step_through(const Boundary& boundary, const Physics& physics, const State<double>& start, double until,
                     const Scheme& scheme);

}  // namespace bankshot::app::report
