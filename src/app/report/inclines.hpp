// SPDX-License-Identifier: MIT
//
// Other ways to follow a ball on a table that leans (detail/incline.hpp has the law), to compare with ours. They follow
// it until it stops, or until a given moment.
//   series          a power series in the clock σ of incline.hpp, cut off after some terms, in equal steps
//   dormand_prince  order five, in time (Boost.Odeint, steppers.cpp); near the stop, where the direction of friction is
//                   lost, it goes straight ahead
//   perturbed       the level closed form, and what a slope adds to it in first order
#pragma once

#include "bankshot/detail/incline.hpp"

namespace bankshot::app::report {

/// The state after some time: w and its integral.
struct Slipped {
  double time;  ///< s
  Vec2d moved;  ///< m
  Vec2d w;      ///< m/s
};

/// Uses `terms` terms of the series in each step; the friction must not grow with the speed.
Slipped series(const detail::Incline<double>& law, const Vec2d& w, double until, int terms, int steps);

/// Integrates until a given moment in equal steps.
Slipped dormand_prince(const detail::Incline<double>& law, const Vec2d& w, double until, int steps);
/// Integrates until w is 0, with `tolerance` absolute and relative.
Slipped dormand_prince_to_stop(const detail::Incline<double>& law, const Vec2d& w, double tolerance);

/// Follows the ball until w is 0.
Slipped perturbed(const detail::Incline<double>& law, const Vec2d& w);

/// Evaluates the closed forms of incline.hpp, until w is 0 or until an earlier moment.
Slipped exactly(const detail::Incline<double>& law, const Vec2d& w);
Slipped exactly(const detail::Incline<double>& law, const Vec2d& w, double until);

}  // namespace bankshot::app::report
