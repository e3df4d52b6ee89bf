// SPDX-License-Identifier: MIT
//
// Cushion impact with friction at the nose and at the cloth: Mathavan, Jackson & Parkin, A theoretical
// analysis of billiard ball dynamics under cushion impacts, Proc. IMechE C 224 (2010),
// doi 10.1243/09544062JMES1964. The model is an ODE in the normal impulse. It is integrated by Taylor series whose
// order follows from the tolerance, and every switch between sticking and sliding is located.
// Properties:
//  1. The map is homogeneous of degree one in (v, ω) when the restitution is constant.
//  2. No allocation. One source serves double, dual numbers and 50 digits.
//  3. A ball that does not move into the cushion is left as it is.
//  4. Coefficients may be dual numbers. Decisions (orders, switches) are taken on values, so derivatives by
//     coefficients are as exact as those by the state.
// Limitations: at exactly zero slip (natural roll at the cloth) the map has one-sided derivatives only; the slip then
// counts as constant 0. With large friction the ball can jam between nose and cloth. Then its normal velocity is set
// to 0, and `course` says so.
#pragma once

#include "bankshot/contact/cushion_frame.hpp"
#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/contact/impact_course.hpp"
#include "bankshot/detail/mathavan2010/impact.hpp"
#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {

namespace detail::mathavan {

inline constexpr double negligible = 0.1;  ///< share of the tolerance; a smaller slip counts as 0

/// Computes the velocities from the changes of the slips, which are linear in the friction impulses along x.
template <class T>
void recover(const Nose<T>& nose, const Vec2<T>& cushion, const Vec2<T>& cloth, const T& vy_after, T& vx, T& vy, T& wx,
             T& wy, T& wz) {
  const T a(3.5), b = nose.beta, by = T(1) / (a * a - b * b);
  const T at_cushion = (b * cloth.x - a * cushion.x) * by, at_cloth = (b * cushion.x - a * cloth.x) * by;
  vx -= at_cushion + at_cloth;
  wx += cloth.y - (vy_after - vy);
  wy -= T(2.5) * (at_cushion * nose.sine - at_cloth);
  wz += T(2.5) * at_cushion * nose.cosine;
  vy = vy_after;
}

}  // namespace detail::mathavan

template <class C>
template <class T, class N>
inline void Mathavan2010Of<C>::bounce(const Body& body, State<T>& s, const Vec2<N>& away) const {
  course(body, s, away);
}

template <class C>
template <class T, class N>
inline ImpactCourse Mathavan2010Of<C>::course(const Body& body, State<T>& s, const Vec2<N>& normal) const {
  const Vec2<T> away = to<T>(normal);
  InCushionFrame<T> f = into_frame(s, away);
  const double approach = detail::mathavan::as_double(f.vn);
  const double radius = body.radius;
  const T R(radius);
  const double w2 = detail::mathavan::as_double(T(f.wn * f.wn + f.wt * f.wt + f.wz * f.wz)) * radius * radius;
  const double fast = std::sqrt(detail::mathavan::as_double(dot(s.velocity, s.velocity)) + w2);
  if (!(approach > 0)) return {};
  const T e = restitution(f.vn);
  if (!(approach > bankshot::tolerance::along * fast)) {
    f.vn *= -e;
    out_of_frame(f, away, s);
    return {};
  }
  // The paper's axes: y into the cushion, x = y × z = −t. Mass 1, radius 1, approach speed 1.
  const NoseAngle<Coefficient<T, C>> angle(height, radius);
  const T sine(angle.sine), cosine(angle.cosine);
  const detail::mathavan::Nose<T> nose(sine, cosine, T(friction), T(sliding_friction));
  const T by = T(1) / T(approach), spin = R * by;
  T vx = -f.vt * by, vy = f.vn * by, wx = -f.wt * spin, wy = f.wn * spin, wz = f.wz * spin;
  const Vec2<T> cushion{vx + wy * sine - wz * cosine, wx - vy * sine}, cloth{vx - wy, vy + wx};
  detail::mathavan::Impact<T> impact(nose, cushion, cloth, vy, tolerance,
                                     detail::mathavan::negligible * tolerance * fast / approach);
  impact.run(e);
  detail::mathavan::recover(nose, impact.cushion_slip() - cushion, impact.cloth_slip() - cloth, impact.vy(), vx, vy, wx,
                            wy, wz);
  if (impact.course().jams && vy > T(0)) vy = T(0);
  f = {vy * T(approach), -vx * T(approach), wy / spin, -wx / spin, wz / spin};
  out_of_frame(f, away, s);
  return impact.course();
}

}  // namespace bankshot
