// SPDX-License-Identifier: MIT
//
// Natural roll from the first instant, slowed by rolling friction: a straight line with the constant deceleration μr g
// (Leckie & Greenspan 2006, rolling phase). From speed v, the ball stops after v/(μr g) seconds and v²/(2 μr g) metres.
// If friction grows with the speed, the line is the same, with another clock (drag.hpp).
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/laws.hpp"

namespace bankshot {

/// Returns the rolling phase from velocity v with deceleration a [m/s²].
template <class T, class A>
[[gnu::always_inline]] inline Arc<T> rolling_arc(const Vec2<T>& at, const Vec2<T>& velocity, const A& a) {
  const T speed2 = dot(velocity, velocity);
  if (!(value(speed2) > 0)) return {at, velocity, {T(0), T(0)}, T(0), PhaseEnd::rest};
  if (value(a) == 0) return {at, velocity, {T(0), T(0)}, T(forever), PhaseEnd::none};
  using std::sqrt;
  const T speed = sqrt(speed2);
  return {at, velocity, velocity * T(-a / speed), speed / a, PhaseEnd::rest};
}

/// Returns the rolling phase with friction that grows with the speed.
template <class T, class C>
Arc<T> rolling_arc(const Vec2<T>& at, const Vec2<T>& velocity, const RollingFrictionOf<C>& friction, double g) {
  using K = Coefficient<T, C>;
  const K a = K(friction.at_rest) * g;
  Arc<T> arc = rolling_arc(at, velocity, a);
  if (value(friction.per_speed) == 0 || !(value(arc.duration) > 0)) return arc;
  arc.drag = {T(a), T(K(friction.per_speed) * g)};
  arc.acceleration = {T(0), T(0)};
  const T speed = norm(velocity);
  arc.duration = arc.drag.length(speed, T(0)) / speed;
  return arc;
}

template <class C>
template <class T>
inline Arc<T> RollingOf<C>::arc(const Body&, const State<T>& s) const {
  return rolling_arc(s.at, s.velocity, Coefficient<T, C>(Coefficient<T, C>(friction) * g));
}

template <class C>
template <class T>
inline void RollingOf<C>::finish(const Body&, State<T>& s, const Arc<T>& arc) const {
  if (arc.end == PhaseEnd::rest) s.velocity = {T(0), T(0)};
}

template <class C>
template <class T>
inline Vec3<T> RollingOf<C>::spin(const Body& body, const State<T>& s) const {
  return natural_roll(s.velocity, body.radius);
}

}  // namespace bankshot
