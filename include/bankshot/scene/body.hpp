// SPDX-License-Identifier: MIT
//
// What a ball is made of, wherever it is and whatever it does. The laws of motion and of contact hold
// coefficients only and are told the body of the ball they act on, so that a radius stands in one place.
#pragma once

#include <cmath>

namespace bankshot {

struct Body {
  double radius = 0.028575;  ///< m; 0 is a point, in `ideal` and `rolling`
  double mass = 0.170097;    ///< kg

  friend bool operator==(const Body&, const Body&) = default;
};

/// Distance of the centres of two balls that touch, in plan [m]. Balls are spheres on one cloth: centres at heights a
/// and b that are a + b apart are 2 √(ab) apart in plan. Equal balls touch at exactly 2 a.
inline double touching_distance(double a, double b) { return a == b ? 2 * a : 2 * std::sqrt(a * b); }
inline double touching_distance(const Body& a, const Body& b) { return touching_distance(a.radius, b.radius); }

}  // namespace bankshot
