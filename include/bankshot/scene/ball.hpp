// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/angle.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

struct Ball {
  Vec2d at{};  ///< centre [m]
  Body body{};
  std::string id = "cue";  ///< name; the default is that of the cue ball
};

/// Speed and aim of the cue ball just after the strike.
struct Launch {
  double speed;  ///< m/s
  double angle;  ///< rad, anticlockwise from +x, in [0, 2π)
};

/// Spin at launch in units of natural roll, each ω R / v (dimensionless). It needs the physics `spin`.
struct LaunchSpin {
  double top = 0;    ///< topspin: 0 slides, 1 rolls, negative draws
  double side = 0;   ///< english, about the vertical axis; positive anticlockwise seen from above
  double masse = 0;  ///< about the line of travel; positive curves to the right
  bool operator==(const LaunchSpin&) const = default;
};

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
