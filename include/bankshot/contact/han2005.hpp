// SPDX-License-Identifier: MIT
//
// Cushion impact with spin: Han, Dynamics in carom and three cushion billiards, J. Mech. Sci. Tech.
// 19 (2005) 976-984. The ball meets the nose at height h above the cloth; normal restitution acts
// along the line from the nose to the centre, friction across it, sticking or sliding.
//   θ: sin θ = (h − R)/R;  A = 7/(2m), B = 1/m, I = 2mR²/5
// The map is homogeneous of degree one in (v, ω) when the restitution is constant.
// Limitation of the law: at low restitution (about e < tan²θ) it leaves the ball moving into the
// cushion; then the normal velocity is set to 0 and the ball stays at the cushion.
#pragma once

#include "bankshot/contact/cushion_frame.hpp"
#include "bankshot/contact/restitution.hpp"

namespace bankshot {

struct Han2005 {
  double radius = 0.028575;         ///< R [m]
  double height = 1.28 * 0.028575;  ///< h [m], R < h < 2R
  Restitution restitution{};
  double friction = 0.2;  ///< f, between ball and cushion

  template <class T, class N>
  void bounce(State<T>& s, const Vec2<N>& normal) const {
    using std::sqrt;
    const Vec2<T> away = to<T>(normal);
    InCushionFrame<T> f = into_frame(s, away);
    const NoseAngle nose(height, radius);
    const T sine(nose.sine), cosine(nose.cosine), R(radius);
    // eqs 14-16, for mass 1: slip of the contact point along and across, approach speed
    const T sx = f.vn * sine + R * f.wt;
    const T sy = -f.vt - R * f.wz * cosine + R * f.wn * sine;
    const T c = f.vn * cosine;
    constexpr double a = 7.0 / 2;
    const T normal_impulse = (T(1) + restitution(f.vn)) * c;  // eq 17, PzE
    // Sticking needs |s|/A <= f PzE; squares are compared, for a root of 0 has no derivative.
    const T limit = T(friction * a) * normal_impulse, slip2 = sx * sx + sy * sy;
    T px = sx / T(a), py = sy / T(a);  // eqs 18-19
    if (slip2 > limit * limit) {
      const T share = limit / sqrt(slip2);  // eqs 20-21
      px *= share;
      py *= share;
    }
    // eqs 22-23: impulses into, along and above the cushion
    const T ix = -px * sine - normal_impulse * cosine, iy = py, iz = px * cosine - normal_impulse * sine;
    const T by_inertia = T(5.0 / 2) / R;  // R / I for mass 1
    f.vn += ix;
    f.vt += iy;
    f.wn -= by_inertia * iy * sine;
    f.wt += by_inertia * (ix * sine - iz * cosine);
    f.wz += by_inertia * iy * cosine;
    if (f.vn > T(0)) f.vn = T(0);
    out_of_frame(f, away, s);
  }
};

}  // namespace bankshot
