// SPDX-License-Identifier: MIT
//
// The physical properties of a ball, independent of its state. The laws of motion and contact hold only
// coefficients and receive the body of the ball as an argument, so that its radius is stored in one place.
#pragma once

#include <cmath>

namespace bankshot {

struct Body {
  double radius = 0.028575;  ///< m; 0 means a point, allowed in `ideal` and `rolling`
  double mass = 0.170097;    ///< kg

  friend bool operator==(const Body&, const Body&) = default;
};

/// Returns the distance in plan of the centres of two touching balls [m]. Balls are spheres on one cloth: centres at
/// heights a and b that are a + b apart are 2 √(ab) apart in plan. Equal balls touch at exactly 2 a.
inline double touching_distance(double a, double b) { return a == b ? 2 * a : 2 * std::sqrt(a * b); }
inline double touching_distance(const Body& a, const Body& b) { return touching_distance(a.radius, b.radius); }

}  // namespace bankshot
