// SPDX-License-Identifier: MIT
//
// Ways to follow a ball on a table that leans (detail/incline.hpp has the law), to compare with ours: until it stops,
// or until a moment.
//   series          a power series in the clock σ of incline.hpp, cut off after some terms, in equal steps
//   dormand_prince  order five, in time (Boost.Odeint, steppers.cpp); near the stop, where the direction of friction is
//                   lost, straight ahead
//   perturbed       the level closed form and what a slope adds to it in first order
#pragma once

#include "bankshot/detail/incline.hpp"

namespace bankshot::app::report {

/// w after some time, and its integral.
struct Slipped {
  double time;  ///< s
  Vec2d moved;  ///< m
  Vec2d w;      ///< m/s
};

/// By `terms` of the series a step; a friction that does not grow with the speed.
Slipped series(const Incline<double>& law, const Vec2d& w, double until, int terms, int steps);

/// Until a moment by equal steps.
Slipped dormand_prince(const Incline<double>& law, const Vec2d& w, double until, int steps);
/// Until w is 0, keeping a tolerance, absolute and relative.
Slipped dormand_prince_to_stop(const Incline<double>& law, const Vec2d& w, double tolerance);

/// Until w is 0.
Slipped perturbed(const Incline<double>& law, const Vec2d& w);

/// The closed forms of incline.hpp; until w is 0, or until a moment before.
Slipped exactly(const Incline<double>& law, const Vec2d& w);
Slipped exactly(const Incline<double>& law, const Vec2d& w, double until);

}  // namespace bankshot::app::report
