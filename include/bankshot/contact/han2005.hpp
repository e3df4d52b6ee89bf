// SPDX-License-Identifier: MIT
//
// Cushion impact with spin: Han, Dynamics in carom and three cushion billiards, J. Mech. Sci. Tech. 19 (2005) 976-984.
// The ball meets the nose at height h above the cloth. Normal restitution acts along the line from the nose to the
// centre. Friction acts across it, sticking or sliding.
//   θ: sin θ = (h − R)/R;  A = 7/(2m), B = 1/m, I = 2mR²/5
// The map is homogeneous of degree one in (v, ω) if the restitution is constant.
// Limitation of the law: at low restitution (about e < tan²θ) it leaves the ball moving into the cushion. Then the
// normal velocity is set to 0, and the ball stays at the cushion.
#pragma once

#include "bankshot/contact/cushion_frame.hpp"
#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

template <class C>
template <class T, class N>
inline void Han2005Of<C>::bounce(const Body& body, State<T>& s, const Vec2<N>& away) const {
  using std::sqrt;
  using Number = Real<T>;
  using K = Coefficient<T, C>;
  InCushionFrame<T> f = into_frame(s, away);
  const NoseAngle<K> nose(height, body.radius);
  const K &sine = nose.sine, &cosine = nose.cosine;
  const Number R(body.radius);
  // eqs 14-16, for mass 1: slip of the contact point along and across, approach speed
  const T sx = f.vn * sine + f.wt * R;
  const T sy = f.wn * K(R * sine) - f.vt - f.wz * K(R * cosine);
  constexpr double a = 7.0 / 2;
  const T normal_impulse = restitution.rebound(f.vn) * cosine;  // eq 17, PzE
  // Sticking needs |s|/A <= f PzE. Squares are compared, because a root of 0 has no derivative.
  const T limit = normal_impulse * K(K(friction) * a), slip2 = sx * sx + sy * sy;
  const bool slides = value(slip2) > value(limit) * value(limit);
  const T share = slides ? T(limit / sqrt(slip2) / Number(a)) : T(1 / Number(a));
  const T px = sx * share, py = sy * share;  // eqs 18-21
  // eqs 22-23: impulses into, along and above the cushion
  const T ix = -px * sine - normal_impulse * cosine, iz = px * cosine - normal_impulse * sine;
  const T turned = py * Number(Number(5.0 / 2) / R);  // R / I for mass 1
  f.vn += ix;
  f.vt += py;
  f.wn -= turned * sine;
  f.wt += (ix * sine - iz * cosine) * Number(Number(5.0 / 2) / R);
  f.wz += turned * cosine;
  if (value(f.vn) > 0) f.vn = T(0);
  out_of_frame(f, away, s);
}

}  // namespace bankshot
