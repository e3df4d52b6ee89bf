// SPDX-License-Identifier: MIT
#include "bankshot/scene/ball.hpp"

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

}  // namespace bankshot
