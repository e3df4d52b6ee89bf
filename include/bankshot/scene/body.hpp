// SPDX-License-Identifier: MIT
//
// What a ball is made of, wherever it is and whatever it does. The laws of motion and of contact hold
// coefficients only and are told the body of the ball they act on, so that a radius stands in one place.
#pragma once

namespace bankshot {

struct Body {
  double radius = 0.028575;  ///< m; 0 is a point, in `ideal` and `rolling`
  double mass = 0.170097;    ///< kg

  friend bool operator==(const Body&, const Body&) = default;
};

}  // namespace bankshot
