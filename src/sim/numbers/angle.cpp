// SPDX-License-Identifier: MIT
#include "bankshot/numbers/angle.hpp"

#include <cmath>
#include <limits>

namespace bankshot {

Vec2d direction(double angle) {
  const double rounding = std::abs(angle) * std::numeric_limits<double>::epsilon() / 2;
  const auto clean = [&](double c) { return std::abs(c) <= rounding ? 0.0 : c; };
  return {clean(std::cos(angle)), clean(std::sin(angle))};
}

double wrap_angle(double angle) {
  constexpr double turn = radians(360);
  double a = std::fmod(angle, turn);
  if (a < 0) a += turn;
  return a < turn ? a : 0.0;
}

double exact_degrees(double angle) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nearest = degrees(angle);
  double below = nearest, above = nearest;
  for (int i = 0; i < 3; ++i) {
    if (radians(below) == angle) return below;
    if (radians(above) == angle) return above;
    below = std::nextafter(below, -infinity);
    above = std::nextafter(above, infinity);
  }
  return nearest;
}

}  // namespace bankshot
