// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bankshot/motion/arc.hpp"
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

/// Returns the unit vector at `angle`. A component below the rounding of the angle itself becomes 0, so that 270°
/// runs exactly along a cushion although no double is 3π/2.
Vec2d direction(double angle);

/// Returns `angle` reduced to [0, 2π).
double wrap_angle(double angle);

/// Returns the degrees that convert back to exactly `angle`, if any do. The result of `degrees` may be off by a
/// rounding, so an angle that is written and read repeatedly would drift.
double exact_degrees(double angle);

constexpr double radians(double degrees) { return degrees * (3.14159265358979323846 / 180); }
constexpr double degrees(double radians) { return radians * (180 / 3.14159265358979323846); }

}  // namespace bankshot
