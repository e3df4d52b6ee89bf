// SPDX-License-Identifier: MIT
//
// One step of the cushion impact of Mathavan, Jackson & Parkin (2010) as Taylor series in the normal
// impulse P. The ball has mass 1 and radius 1 (spin velocities are Rω); x runs along the cushion, y
// into it. With I = (Ix, Iy) and C = (Cx, Cy) the friction at the cushion and at the cloth per unit of
// P, and q = sin θ + Iy cos θ the load on the cloth, the paper's equations of motion become
//   ẋI′ = −7/2 Ix − β Cx         ẏI′ = sin θ cos θ − (5/2 + sin²θ) Iy − γ Cy      slip at the cushion
//   ẋC′ = −β Ix − 7/2 Cx         ẏC′ = −cos θ − γ Iy − 7/2 Cy                     slip at the cloth
//   vy′ = −(cos θ − Iy sin θ + Cy),   β = 1 − 5/2 sin θ,  γ = 5/2 − sin θ
// Sliding: I = μw f, C = μs q f, f the direction of that slip. Sticking: the force that keeps the slip 0.
// Each slip is written r f in polar form, r′ = N and r θ′ = T (N and T: slip acceleration along and
// across f), because these recurrences also start from r = 0, where a direction needs T = 0:
// at order n they are linear in the coefficient θn, with the same slope −κ at every order.
#pragma once

#include "bankshot/contact/mathavan2010_polynomial.hpp"
#include "bankshot/vec.hpp"

namespace bankshot::mathavan {

/// What does not change during an impact.
template <class T>
struct Nose {
  T sine, cosine, mu_w, mu_s;
  T beta, gamma, yy, push;  ///< β, γ, 5/2 + sin²θ, sin θ cos θ

  Nose(const T& s, const T& c, const T& w, const T& cloth)
      : sine(s),
        cosine(c),
        mu_w(w),
        mu_s(cloth),
        beta(T(1) - T(2.5) * s),
        gamma(T(2.5) - s),
        yy(T(2.5) + s * s),
        push(s * c) {}
};

enum class Slip {
  sticks,  ///< is 0 and stays 0
  starts,  ///< is 0 and grows
  slides
};

template <class T>
struct Contact {
  Slip slip = Slip::slides;
  T size{};                   ///< r now
  Vec2<T> direction{};        ///< f now
  Series<T> r, turn, fx, fy;  ///< turn: of θ′
  Series<T> ix, iy;           ///< friction impulse per unit of P
  Series<T> ax, ay;           ///< slip acceleration
  Series<T> along, across;    ///< N and T

  bool moves() const { return slip != Slip::sticks; }
};

template <class T>
struct Expansion {
  explicit Expansion(const Nose<T>& n) : nose(n) {}

  Nose<T> nose;
  Contact<T> cushion, cloth;
  bool lifted = false;  ///< q < 0: the cushion's friction carries the ball, the cloth's is 0
  T unit{1};            ///< of P: dP = unit dσ, so that no coefficient overflows
  int clock = -1;       ///< dP = unit (r / r0) dσ with the slip of this contact (0 cushion, 1 cloth); −1: without
  Series<T> q, vy, work, vy_rate, pace;

  /// Coefficient n of forces and accelerations from those of the directions.
  void forces(std::size_t n) {
    const int order = static_cast<int>(n);
    const T one = n == 0 ? T(1) : T(0);
    Contact<T>&w = cushion, &c = cloth;
    if (w.moves()) {
      w.ix[n] = nose.mu_w * w.fx[n];
      w.iy[n] = nose.mu_w * w.fy[n];
    } else {
      // ẏI′ = 0 with Cy = μs (sin θ + Iy cos θ) fy is one division of series.
      const T g = nose.gamma * nose.mu_s;
      w.iy[n] = one * nose.push - g * nose.sine * c.fy[n] - g * nose.cosine * product(c.fy, w.iy, order, 1);
      w.iy[n] /= nose.yy + g * nose.cosine * c.fy[0];
    }
    q[n] = one * nose.sine + w.iy[n] * nose.cosine;
    if (!c.moves()) {
      c.ix[n] = nose.beta * w.ix[n] / T(-3.5);
      c.iy[n] = (one * nose.cosine + nose.gamma * w.iy[n]) / T(-3.5);
    } else if (lifted) {
      c.ix[n] = c.iy[n] = T(0);
    } else {
      T x(0), y(0);
      for (std::size_t j = 0; j <= n; ++j) {
        x += q[j] * c.fx[n - j];
        y += q[j] * c.fy[n - j];
      }
      c.ix[n] = nose.mu_s * x;
      c.iy[n] = nose.mu_s * y;
    }
    if (!w.moves()) w.ix[n] = nose.beta * c.ix[n] / T(-3.5);
    w.ax[n] = T(-3.5) * w.ix[n] - nose.beta * c.ix[n];
    w.ay[n] = one * nose.push - nose.yy * w.iy[n] - nose.gamma * c.iy[n];
    c.ax[n] = -nose.beta * w.ix[n] - T(3.5) * c.ix[n];
    c.ay[n] = -one * nose.cosine - nose.gamma * w.iy[n] - T(3.5) * c.iy[n];
    vy_rate[n] = nose.sine * w.iy[n] - one * nose.cosine - c.iy[n];
    for (Contact<T>* k : {&w, &c}) {
      if (!k->moves()) continue;
      // Four products in one loop: their sums do not wait for each other.
      T xx(0), yy(0), yx(0), xy(0);
      for (std::size_t j = 0; j <= n; ++j) {
        xx += k->ax[j] * k->fx[n - j];
        yy += k->ay[j] * k->fy[n - j];
        yx += k->ay[j] * k->fx[n - j];
        xy += k->ax[j] * k->fy[n - j];
      }
      k->along[n] = xx + yy;
      k->across[n] = yx - xy;
    }
  }

  /// Coefficient n > 0 of the directions from θ1 … θn: f′ = θ′ (−fy, fx).
  static void turn_to(Contact<T>& k, std::size_t n) {
    T x(0), y(0);
    for (std::size_t j = 0; j < n; ++j) {
      x -= k.turn[j] * k.fy[n - 1 - j];
      y += k.turn[j] * k.fx[n - 1 - j];
    }
    const T by = T(1) / T(static_cast<int>(n));
    k.fx[n] = x * by;
    k.fy[n] = y * by;
  }
  void turn_to(std::size_t n) {
    if (cushion.moves()) turn_to(cushion, n);
    if (cloth.moves()) turn_to(cloth, n);
  }

  /// −∂T/∂θ at a contact whose direction is being chosen, read off the recurrence at order 1.
  T stiffness(Contact<T>& k) {
    for (Contact<T>* other : {&cushion, &cloth}) other->fx[1] = other->fy[1] = T(0);
    forces(1);
    const T still = k.across[1];
    k.fx[1] = -k.fy[0];
    k.fy[1] = k.fx[0];
    forces(1);
    return still - k.across[1];
  }

  /// θn of a contact that starts: (n r1 + κ) θn = Tn at θn = 0, less the terms of r2, r3, …
  void start_turning(Contact<T>& k, std::size_t n, const T& kappa) {
    const int order = static_cast<int>(n);
    forces(n);
    T rest = unit * k.across[n];
    for (std::size_t j = 2; j <= n; ++j) rest -= k.r[j] * k.turn[n - j];
    k.turn[n - 1] = T(order) * rest / (T(order) * k.r[1] + unit * kappa);
    turn_to(k, n);
  }

  /// Coefficient n + 1 of the slips, vy and the work from coefficient n of the accelerations.
  void integrate(std::size_t n, double sign) {
    const int order = static_cast<int>(n);
    const T by = T(1) / T(order + 1);
    const auto paced = [&](const Series<T>& a) { return clock < 0 ? unit * a[n] : product(pace, a, order); };
    for (int i = 0; i < 2; ++i) {
      Contact<T>& k = i == 0 ? cushion : cloth;
      if (!k.moves()) continue;
      k.r[n + 1] = paced(k.along) * by;
      if (k.slip == Slip::starts) continue;
      if (i == clock)
        k.turn[n] = unit * k.across[n] / k.size;
      else
        k.turn[n] = (paced(k.across) - product(k.r, k.turn, order, 1)) / k.size;
      if (i == clock) pace[n + 1] = unit * k.r[n + 1] / k.size;
    }
    work[n + 1] = T(sign) * nose.cosine * paced(vy) * by;  // W′ = |vy| cos θ
    vy[n + 1] = paced(vy_rate) * by;
  }

  /// Order 0: forces and accelerations here and now.
  void begin() {
    for (Contact<T>* k : {&cushion, &cloth}) {
      k->r[0] = k->slip == Slip::slides ? k->size : T(0);
      k->fx[0] = k->moves() ? k->direction.x : T(0);
      k->fy[0] = k->moves() ? k->direction.y : T(0);
    }
    forces(0);
  }

  /// All coefficients up to `order`, after begin(). `sign` is that of vy.
  void expand(int order, double sign) {
    pace[0] = unit;
    T kappa[2]{};
    if (cushion.slip == Slip::starts) kappa[0] = stiffness(cushion);
    if (cloth.slip == Slip::starts) kappa[1] = stiffness(cloth);
    for (Contact<T>* k : {&cushion, &cloth})
      if (k->slip == Slip::starts && k->along[0] < T(0)) k->along[0] = T(0);
    integrate(0, sign);
    for (std::size_t n = 1; n < static_cast<std::size_t>(order); ++n) {
      for (Contact<T>* k : {&cushion, &cloth})
        if (k->slip == Slip::starts) k->turn[n - 1] = T(0);
      turn_to(n);
      if (cushion.slip == Slip::starts) start_turning(cushion, n, kappa[0]);
      if (cloth.slip == Slip::starts) start_turning(cloth, n, kappa[1]);
      forces(n);
      integrate(n, sign);
    }
    const auto last = static_cast<std::size_t>(order);
    for (Contact<T>* k : {&cushion, &cloth})
      if (k->slip == Slip::starts) k->turn[last - 1] = T(0);
    turn_to(last);
  }
};

}  // namespace bankshot::mathavan
