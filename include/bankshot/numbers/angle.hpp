// SPDX-License-Identifier: MIT
//
// Angles are radians, anticlockwise from +x. Files and the command line use degrees.
#pragma once

#include "bankshot/numbers/vec.hpp"

namespace bankshot {

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
