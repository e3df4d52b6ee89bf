// SPDX-License-Identifier: MIT
//
// State of the cushion impact of mathavan2010, and the switches between sticking and sliding in it.
//   stick → slide where the force that keeps a slip at 0 leaves its cone
//   load          where q, the load on the cloth, changes sign
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/contact/impact_course.hpp"
#include "bankshot/detail/mathavan2010/start.hpp"

namespace bankshot::detail::mathavan {

template <class T>
class Switches {
 protected:
  using Contact = mathavan::Contact<T>;

  Switches(const Nose<T>& nose, double tolerance) : tolerance_(tolerance), e_(nose) {}

  static Vec2<T> slip(const Contact& k) { return k.slip == Slip::slides ? k.direction * k.size : Vec2<T>{T(0), T(0)}; }

  static void set_slip(Contact& k, const Vec2<T>& slip, double zero) {
    using std::sqrt;
    k.slip = Slip::sticks;
    const T square = dot(slip, slip);
    if (!(as_double(square) > zero * zero)) return;
    k.slip = Slip::slides;
    k.size = sqrt(square);
    k.direction = slip / k.size;
  }

  T margin(const Contact& k, const T& ix, const T& iy, const T& q) const {
    T limit = e_.nose.mu_w;
    if (&k == &e_.cloth) limit = q > T(0) ? T(e_.nose.mu_s * q) : T(0);
    return ix * ix + iy * iy - limit * limit;
  }
  T margin(const Contact& k) const { return margin(k, k.ix[0], k.iy[0], e_.q[0]); }

  void note() {
    const auto bits =
        (e_.cushion.moves() ? 1u : 0u) | (e_.cloth.moves() ? 2u : 0u) | (e_.lifted ? 4u : 0u) | (sign_ < 0 ? 8u : 0u);
    if (course_.modes < static_cast<int>(course_.mode.size()))
      course_.mode[static_cast<std::size_t>(course_.modes)] = static_cast<ImpactCourse::Mode>(bits);
    ++course_.modes;
  }

  /// Decides for every contact whose slip is 0 if it sticks or starts to slide, and in which direction.
  void settle() {
    for (Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::starts) k->slip = Slip::sticks;
    load();
    if (!e_.cushion.moves() && !e_.cloth.moves())
      settle_both();
    else
      for (Contact* k : {&e_.cushion, &e_.cloth})
        if (!k->moves()) {
          e_.begin();
          if (as_double(margin(*k)) > rounding()) start(*k);
        }
    load();
    note();
  }

  void load() {
    e_.lifted = false;
    if (!e_.cushion.moves()) return;
    e_.lifted = as_double(e_.nose.sine + e_.nose.mu_w * e_.nose.cosine * e_.cushion.direction.y) < 0;
  }

  /// Settles both contacts if neither slips. That happens only at vy = 0, in the plane of a head-on shot. The motion
  /// stays in that plane, so the directions are ±y, and the first consistent pair is taken.
  void settle_both() {
    Contact &w = e_.cushion, &c = e_.cloth;
    for (const int cloth : {-1, 1, 0})
      for (const int cushion : {0, 1, -1}) {
        if (cloth == 0 && cushion == 0) continue;
        w.slip = cushion == 0 ? Slip::sticks : Slip::starts;
        c.slip = cloth == 0 ? Slip::sticks : Slip::starts;
        w.size = c.size = T(0);
        w.direction = {T(0), T(cushion)};
        c.direction = {T(0), T(cloth)};
        load();
        e_.begin();
        const bool fits_w = w.moves() ? as_double(e_.cushion.along[0]) > 0 : as_double(margin(w)) <= 0;
        const bool fits_c = c.moves() ? as_double(e_.cloth.along[0]) > 0 : as_double(margin(c)) <= 0;
        if (fits_w && fits_c) return;
      }
    course_.jams = true;
  }

  /// Finds the direction in which contact k leaves 0, where T = 0. The first guess is that of a small slip, or the
  /// direction of the force that would keep the slip at 0. This one is exact if the contact's inverse mass is
  /// isotropic. Newton's method improves it.
  void start(Contact& k) {
    using std::sqrt;
    if (!k.moves()) {
      const T force = sqrt(k.ix[0] * k.ix[0] + k.iy[0] * k.iy[0]);
      k.direction = {k.ix[0] / force, k.iy[0] / force};
      k.size = T(0);
    }
    k.slip = Slip::starts;
    bool last = false;
    constexpr int most = 50;
    for (int i = 0; i < most; ++i) {
      load();
      e_.begin();
      const T kappa = e_.stiffness(k);
      if (!(std::abs(as_double(kappa)) > 0)) return;
      T turn = k.across[0] / kappa;
      constexpr double far = 0.5;
      if (std::abs(as_double(turn)) > far) turn = T(as_double(turn) > 0 ? far : -far);
      const Vec2<T> d = k.direction + perpendicular(k.direction) * turn;
      k.direction = d / norm(d);
      if (last) return;
      last = as_double(turn) * as_double(turn) <= tolerance_;
    }
  }

  /// Returns the margin that counts as 0. Forces are recomputed after a switch that was located on them, and rounding
  /// must not decide.
  double rounding() const { return 1e-14 * as_double(e_.nose.mu_w * e_.nose.mu_w); }

  double tolerance_;
  T vy_{}, work_{0}, target_{0};
  int sign_ = 1;  ///< 1 in compression, −1 in restitution
  Start<T> e_;
  ImpactCourse course_;
};

}  // namespace bankshot::detail::mathavan
