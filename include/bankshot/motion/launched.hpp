// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/ball.hpp"

namespace bankshot {

/// Returns the state of a ball launched from `at` with `velocity`.
template <class T>
State<T> launched(const Vec2d& at, double radius, const Vec2<T>& velocity, const LaunchSpin& spin) {
  State<T> s{to<T>(at), velocity, {T(0), T(0), T(0)}};
  if (radius == 0) return s;
  const Vec2<T> v = velocity / T(radius), rolled = perpendicular(v);
  s.spin.x = rolled.x * T(spin.top) + v.x * T(spin.masse);
  s.spin.y = rolled.y * T(spin.top) + v.y * T(spin.masse);
  if (spin.side != 0) s.spin.z = norm(v) * T(spin.side);
  return s;
}

}  // namespace bankshot
