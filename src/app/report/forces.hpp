// SPDX-License-Identifier: MIT
//
// The forces of one phase as a right-hand side, and one step of the fixed-step methods; for steppers.cpp.
#pragma once

#include <array>

#include "app/report/steppers.hpp"

namespace bankshot::app::report {

using Coordinates = std::array<double, 6>;  // x, y, vx, vy, wx, wy
enum class Phase { slide, roll, rest };

inline Vec2d velocity_of(const Coordinates& y) { return {y[2], y[3]}; }

inline Coordinates moved(const Coordinates& y, const Coordinates& rate, double h) {
  Coordinates out;
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = y[i] + h * rate[i];
  return out;
}

/// The right-hand side in one phase; `along` is û of a slide, v̂ of a roll.
struct Forces {
  Phase phase;
  Vec2d along;
  double sliding;             ///< μs g
  double rolling, per_speed;  ///< a g [m/s²], b g [1/s]
  double turning;             ///< 5 μs g / 2R [rad/s²]

  Coordinates operator()(const Coordinates& y) const {
    const double a = phase == Phase::slide ? sliding : rolling + per_speed * dot(velocity_of(y), along);
    const double turn = phase == Phase::slide ? turning : 0;
    return {y[2], y[3], -a * along.x, -a * along.y, -turn * along.y, turn * along.x};
  }
  /// Has the signature that Odeint calls.
  void operator()(const Coordinates& y, Coordinates& rate, double) const { rate = (*this)(y); }
};

inline Coordinates advanced(Scheme::Method method, const Forces& f, const Coordinates& y, double h) {
  const Coordinates k1 = f(y);
  if (method == Scheme::Method::euler) return moved(y, k1, h);
  if (method == Scheme::Method::semi_implicit) {
    Coordinates out = moved(y, k1, h);
    out[0] = y[0] + h * out[2];
    out[1] = y[1] + h * out[3];
    return out;
  }
  const Coordinates k2 = f(moved(y, k1, h / 2)), k3 = f(moved(y, k2, h / 2)), k4 = f(moved(y, k3, h));
  Coordinates out;
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = y[i] + h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
  return out;
}

}  // namespace bankshot::app::report
