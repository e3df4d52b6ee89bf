// SPDX-License-Identifier: MIT
//
// A ball on cloth. It slides until its contact point rests on the cloth, then it rolls, then it stops. Vertical spin
// decays in parallel with either phase (Leckie & Greenspan 2006; pooltool's theory notes).
//   slip      u = v − R (ω × ẑ) = (vx − R ωy, vy + R ωx)
//   sliding   v̇ = −μs g û,  ω̇∥ = (5 μs g / 2R)(ẑ × û),  u̇ = −(7/2) μs g û; û is constant, so the
//             path is a parabola, until t = 2|u| / (7 μs g)
//   rolling   v̇ = −μr g v̂,  ω∥ = ẑ × v / R
//   vertical  ω̇z = −sign(ωz) 5 μsp g / (2R), until ωz = 0
// Worked number: a ball hit in the centre at v0 = 2 m/s, with μs = 0.2, rolls after 2 v0/(7 μs g) = 0.291 s and
// 12 v0²/(49 μs g) = 0.499 m, at 5/7 v0.
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/motion/rolling.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {

template <class C>
template <class T>
inline Vec2<T> SlideRollOf<C>::slip(const Body& body, const State<T>& s) {
  const Real<T> R(body.radius);
  return {s.velocity.x - R * s.spin.y, s.velocity.y + R * s.spin.x};
}

template <class C>
template <class T>
inline Arc<T> SlideRollOf<C>::arc(const Body& body, const State<T>& s) const {
  using std::sqrt;
  using Number = Real<T>;
  using K = Coefficient<T, C>;
  const Vec2<T> u = slip(body, s);
  const T slip2 = dot(u, u);
  constexpr double still = tolerance::slip * tolerance::slip;
  if (!(value(slip2) > still * squared_scale(s, body.radius)))
    return rolling_arc(s.at, s.velocity, rolling_friction, g);
  if (value(sliding_friction) == 0) return {s.at, s.velocity, {T(0), T(0)}, T(forever), PhaseEnd::none};
  const K a = K(sliding_friction) * g;
  const T size = sqrt(slip2);
  return {s.at, s.velocity, u * T(-a / size), size * Number(2) / K(Number(7) * a), PhaseEnd::roll, true};
}

template <class C>
template <class T>
inline void SlideRollOf<C>::turn(const Body& body, State<T>& s, const Arc<T>& arc, const T& t) const {
  using Number = Real<T>;
  if (arc.bends && arc.pressed != Press::rolls) {
    // ẑ × û (5 μs g / 2R) t, with û taken from the friction −μs g û.
    const T by_radius = t * Number(Number(2.5) / body.radius);
    s.spin.x += (arc.acceleration.y + arc.taken.y) * by_radius;
    s.spin.y -= (arc.acceleration.x + arc.taken.x) * by_radius;
  } else if (arc.end != PhaseEnd::none) {
    roll(body, s);
  }
  fade(body, s, t);
}

template <class C>
template <class T>
inline void SlideRollOf<C>::fade(const Body& body, State<T>& s, const T& t) const {
  using Number = Real<T>;
  const T lost = t * Coefficient<T, C>(Number(2.5) * spinning_friction * g / body.radius);
  if (value(s.spin.z) > value(lost))
    s.spin.z -= lost;
  else if (value(s.spin.z) < -value(lost))
    s.spin.z += lost;
  else
    s.spin.z = T(0);
}

template <class C>
template <class T>
inline void SlideRollOf<C>::finish(const Body& body, State<T>& s, const Arc<T>& arc) const {
  if (arc.end == PhaseEnd::piece) return;
  if (arc.end == PhaseEnd::rest) s.velocity = {T(0), T(0)};
  if (arc.pressed == Press::slides)
    s.velocity -= slip(body, s) * T(Real<T>(2) / Real<T>(7));
  else if (arc.bends && value(dot(arc.taken, arc.taken)) > Real<T>(0))
    slow_to_roll(body, s);
  roll(body, s);
}

template <class C>
template <class T>
inline void SlideRollOf<C>::roll(const Body& body, State<T>& s) {
  s.spin.x = -s.velocity.y / Real<T>(body.radius);
  s.spin.y = s.velocity.x / Real<T>(body.radius);
}

template <class C>
template <class T>
inline Vec3<T> SlideRollOf<C>::spin(const Body&, const State<T>& s) const {
  return s.spin;
}

template <class C>
template <class T>
inline void SlideRollOf<C>::slow_to_roll(const Body& body, State<T>& s) {
  const T speed2 = dot(s.velocity, s.velocity);
  if (!(value(speed2) > Real<T>(0))) return;
  // The velocity is along the cushion already, and stays exactly so.
  const T part = dot(slip(body, s), s.velocity) / speed2;
  s.velocity -= s.velocity * T(part * (Real<T>(2) / Real<T>(7)));
}

}  // namespace bankshot
