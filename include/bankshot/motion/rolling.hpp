// SPDX-License-Identifier: MIT
//
// Natural roll from the first instant, slowed by rolling friction: a straight line with the
// constant deceleration μr g (Leckie & Greenspan 2006, rolling phase).
// From speed v it stops after v/(μr g) seconds and v²/(2 μr g) metres. Where friction grows with the
// speed the line is the same, with another clock (drag.hpp).
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

/// The rolling phase from velocity v with deceleration a [m/s²].
template <class T>
Arc<T> rolling_arc(const Vec2<T>& at, const Vec2<T>& velocity, const Real<T>& a) {
  const T speed2 = dot(velocity, velocity);
  if (!(value(speed2) > 0)) return {at, velocity, {T(0), T(0)}, T(0), PhaseEnd::rest};
  if (a == 0) return {at, velocity, {T(0), T(0)}, T(forever), PhaseEnd::none};
  using std::sqrt;
  const T speed = sqrt(speed2);
  return {at, velocity, velocity * T(-a / speed), speed / a, PhaseEnd::rest};
}

/// μr = at_rest + per_speed · v, dimensionless.
struct RollingFriction {
  double at_rest = 0.01;
  double per_speed = 0;  ///< s/m, >= 0; where it is not 0, at_rest is greater than 0

  constexpr RollingFriction() = default;
  constexpr RollingFriction(double constant) : at_rest(constant) {}
  constexpr RollingFriction(double rest, double slope) : at_rest(rest), per_speed(slope) {}
};

/// The rolling phase with friction that grows with the speed.
template <class T>
Arc<T> rolling_arc(const Vec2<T>& at, const Vec2<T>& velocity, const RollingFriction& friction, double g) {
  using Number = Real<T>;
  const Number a = Number(friction.at_rest) * g;
  Arc<T> arc = rolling_arc(at, velocity, a);
  if (friction.per_speed == 0 || !(value(arc.duration) > 0)) return arc;
  arc.drag = {a, Number(friction.per_speed) * g};
  arc.acceleration = {T(0), T(0)};
  const T speed = norm(velocity);
  arc.duration = arc.drag.length(speed, T(0)) / speed;
  return arc;
}

struct Rolling {
  double friction = 0.01;  ///< μr, dimensionless, >= 0
  double g = 9.81;         ///< m/s², > 0
  double radius = 0;       ///< m, only to say what natural roll is

  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const State<T>& s) const {
    return rolling_arc(s.at, s.velocity, Real<T>(Real<T>(friction) * g));
  }
  template <class T>
  void turn(State<T>&, const Arc<T>&, const T&) const {}
  template <class T>
  void finish(State<T>& s, const Arc<T>&) const {
    s.velocity = {T(0), T(0)};
  }
  template <class T>
  Vec3<T> spin(const State<T>& s) const {
    return natural_roll(s.velocity, radius);
  }
  double deceleration() const { return friction * g; }
};

}  // namespace bankshot
