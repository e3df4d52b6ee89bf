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

/// Returns the motion in the frame of a cushion. `away` is a unit vector that points away from the cushion; for a
/// straight cushion it has no derivatives.
template <class T, class N>
InCushionFrame<T> into_frame(const State<T>& s, const Vec2<N>& away) {
  const Vec2<N> n = -away, t = perpendicular(n);
  const Vec2<T> w{s.spin.x, s.spin.y};
  return {dot(n, s.velocity), dot(t, s.velocity), dot(n, w), dot(t, w), s.spin.z};
}

template <class T, class N>
void out_of_frame(const InCushionFrame<T>& f, const Vec2<N>& away, State<T>& s) {
  const Vec2<N> n = -away, t = perpendicular(n);
  s.velocity = {f.vn * n.x + f.vt * t.x, f.vn * n.y + f.vt * t.y};
  s.spin = {f.wn * n.x + f.wt * t.x, f.wn * n.y + f.wt * t.y, f.wz};
}

/// Elevation of a cushion's nose above the ball's centre, as an angle: sin θ = (h − R) / R.
template <class N = double>
struct NoseAngle {
  N sine, cosine;
  template <class C>
  NoseAngle(const C& height, double radius)
      : sine((N(height) - radius) / radius), cosine(square_root(N((N(1) - sine) * (N(1) + sine)))) {}
};

}  // namespace bankshot
