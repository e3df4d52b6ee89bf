// SPDX-License-Identifier: MIT
//
// Natural roll from the first instant, slowed by rolling friction: a straight line with the
// constant deceleration μr g (Leckie & Greenspan 2006, rolling phase).
// From speed v it stops after v/(μr g) seconds and v²/(2 μr g) metres.
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

struct Rolling {
  double friction = 0.01;  ///< μr, dimensionless, >= 0
  double g = 9.81;         ///< m/s², > 0

  static constexpr PhaseEnd phase_end = PhaseEnd::rest;
  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const State<T>& s) const {
    const T speed = norm(s.velocity);
    const double a = deceleration();
    if (!(speed > T(0))) return {s.at, s.velocity, {T(0), T(0)}, T(0)};
    if (a == 0) return {s.at, s.velocity, {T(0), T(0)}, T(forever)};
    return {s.at, s.velocity, s.velocity * (T(-a) / speed), speed / T(a)};
  }
  double deceleration() const { return friction * g; }
};

}  // namespace bankshot
