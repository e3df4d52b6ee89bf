// SPDX-License-Identifier: MIT
//
// The frame of a cushion contact: n points into the cushion, t = ẑ × n runs along it.
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

template <class T>
struct InCushionFrame {
  T vn, vt;      ///< m/s
  T wn, wt, wz;  ///< rad/s
};

/// `away` is a unit vector that points away from the cushion.
template <class T>
InCushionFrame<T> into_frame(const State<T>& s, const Vec2<T>& away) {
  const Vec2<T> n = -away, t = perpendicular(n), w{s.spin.x, s.spin.y};
  return {dot(n, s.velocity), dot(t, s.velocity), dot(n, w), dot(t, w), s.spin.z};
}

template <class T>
void out_of_frame(const InCushionFrame<T>& f, const Vec2<T>& away, State<T>& s) {
  const Vec2<T> n = -away, t = perpendicular(n);
  s.velocity = n * f.vn + t * f.vt;
  s.spin = {n.x * f.wn + t.x * f.wt, n.y * f.wn + t.y * f.wt, f.wz};
}

/// The height of a cushion's nose over the ball's centre as an angle: sin θ = (h − R) / R.
struct NoseAngle {
  double sine, cosine;
  NoseAngle(double height, double radius)
      : sine((height - radius) / radius), cosine(std::sqrt((1 - sine) * (1 + sine))) {}
};

}  // namespace bankshot
