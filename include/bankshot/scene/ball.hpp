// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/vec.hpp"

namespace bankshot {

struct Ball {
  Vec2d at{};                ///< centre [m]
  double radius = 0.028575;  ///< m; 0 is a point, in `ideal` and `rolling`
  double mass = 0.170097;    ///< kg
};

/// The two numbers a player chooses.
struct Launch {
  double speed;  ///< m/s
  double angle;  ///< rad, anticlockwise from +x, in [0, 2π)
};

/// Unit vector at `angle`. A component below the rounding of the angle itself is 0, so that 270°
/// runs exactly along a cushion although no double is 3π/2.
Vec2d direction(double angle);

/// `angle` brought into [0, 2π).
double wrap_angle(double angle);

/// The degrees that read back to exactly `angle`, if any do: `degrees` alone may be a rounding off,
/// and an angle that is written and read over and over would drift.
double exact_degrees(double angle);

constexpr double radians(double degrees) { return degrees * (3.14159265358979323846 / 180); }
constexpr double degrees(double radians) { return radians * (180 / 3.14159265358979323846); }

}  // namespace bankshot
