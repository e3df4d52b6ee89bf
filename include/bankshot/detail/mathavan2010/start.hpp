// SPDX-License-Identifier: MIT
//
// One step of the cushion impact of Mathavan, Jackson & Parkin (2010) as Taylor series in the normal impulse P, with
// the forces of law.hpp, for a slip that is 0 and grows. Each slip is written r f in polar form: r′ = N and r θ′ = T,
// where N and T are the slip acceleration along and across f. These recurrences also start from r = 0, where a
// direction needs T = 0. At order n they are linear in the coefficient θn, with the same slope −κ at every order.
// A slip whose r is small, but not 0, and whose direction has settled, follows the same recurrences: what r θ′ adds to
// T is taken from the pass before (the outer solution of a singular perturbation: Hinch, Perturbation Methods, 1991,
// chapter 5).
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/detail/mathavan2010/law.hpp"
#include "bankshot/detail/mathavan2010/polynomial.hpp"
#include "bankshot/numbers/vec.hpp"

namespace bankshot::detail::mathavan {

enum class Slip {
  sticks,  ///< is 0 and stays 0
  starts,  ///< is 0 and grows, or is small and in the direction in which it would grow from 0
  slides
};

template <class T>
struct Contact {
  Slip slip = Slip::slides;
  T size{};                   ///< r now
  Vec2<T> direction{};        ///< f now
  Series<T> r, turn, fx, fy;  ///< `turn` is the series of θ′
  Series<T> ix, iy;           ///< friction impulse per unit of P
  Series<T> ax, ay;           ///< slip acceleration
  Series<T> along, across;    ///< N and T

  bool moves() const { return slip != Slip::sticks; }
};

template <class T>
struct Start {
  explicit Start(const Nose<T>& n) : nose(n) {}

  Nose<T> nose;
  Contact<T> cushion, cloth;
  bool lifted = false;  ///< q < 0: the cushion's friction carries the ball, the cloth's is 0
  T unit{1};            ///< unit of P: dP = unit dσ, so that no coefficient overflows
  Series<T> q, vy, work, vy_rate;

  Sliding sliding() const { return {cushion.moves(), cloth.moves(), lifted}; }

  /// Computes coefficient n of forces and accelerations from those of the directions.
  void forces(std::size_t n) {
    const int order = static_cast<int>(n);
    const T one = n == 0 ? T(1) : T(0);
    Contact<T>&w = cushion, &c = cloth;
    const T known = w.moves() ? T(0) : product(c.fy, w.iy, order, 1);
    const auto times_load = [&](const T& load) {
      q[n] = load;
      Vec2<T> sum{T(0), T(0)};
      for (std::size_t j = 0; j <= n; ++j) {
        sum.x += q[j] * c.fx[n - j];
        sum.y += q[j] * c.fy[n - j];
      }
      return sum;
    };
    const Forces<T> f =
        mathavan::forces<T>(nose, sliding(), one, {w.fx[n], w.fy[n]}, {c.fx[n], c.fy[n]}, c.fy[0], known, times_load);
    q[n] = f.load;
    w.ix[n] = f.cushion.x;
    w.iy[n] = f.cushion.y;
    c.ix[n] = f.cloth.x;
    c.iy[n] = f.cloth.y;
    w.ax[n] = f.cushion_rate.x;
    w.ay[n] = f.cushion_rate.y;
    c.ax[n] = f.cloth_rate.x;
    c.ay[n] = f.cloth_rate.y;
    vy_rate[n] = f.vy_rate;
    for (Contact<T>* k : {&w, &c}) {
      if (!k->moves()) continue;
      // Four products share one loop, so that their sums do not wait for each other.
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

  /// Computes coefficient n > 0 of the directions from θ1 … θn: f′ = θ′ (−fy, fx).
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

  /// Returns κ = −∂T/∂θ at a contact whose direction is being chosen, read off the recurrence at order 1.
  T stiffness(Contact<T>& k) {
    for (Contact<T>* other : {&cushion, &cloth}) other->fx[1] = other->fy[1] = T(0);
    forces(1);
    const T still = k.across[1];
    k.fx[1] = -k.fy[0];
    k.fy[1] = k.fx[0];
    forces(1);
    return still - k.across[1];
  }

  /// Computes θn of a contact that starts: (n r1 + κ) θn = Tn at θn = 0, less the terms of r2, r3, … and that of r0,
  /// which is known from the pass before.
  void start_turning(Contact<T>& k, std::size_t n, const T& kappa) {
    const int order = static_cast<int>(n);
    forces(n);
    T rest = unit * k.across[n] - k.r[0] * k.turn[n];
    for (std::size_t j = 2; j <= n; ++j) rest -= k.r[j] * k.turn[n - j];
    k.turn[n - 1] = T(order) * rest / (T(order) * k.r[1] + unit * kappa);
    turn_to(k, n);
  }

  /// Computes coefficient n + 1 of the slips, vy and the work from coefficient n of the accelerations.
  void integrate(std::size_t n, double sign) {
    const int order = static_cast<int>(n);
    const T by = T(1) / T(order + 1);
    for (Contact<T>* k : {&cushion, &cloth}) {
      if (!k->moves()) continue;
      k->r[n + 1] = unit * k->along[n] * by;
      if (k->slip == Slip::starts) continue;
      k->turn[n] = (unit * k->across[n] - product(k->r, k->turn, order, 1)) / k->size;
    }
    work[n + 1] = T(sign) * nose.cosine * unit * vy[n] * by;  // W′ = |vy| cos θ
    vy[n + 1] = unit * vy_rate[n] * by;
  }

  /// Computes order 0: the current forces and accelerations.
  void begin() {
    for (Contact<T>* k : {&cushion, &cloth}) {
      k->r[0] = k->moves() ? k->size : T(0);
      k->fx[0] = k->moves() ? k->direction.x : T(0);
      k->fy[0] = k->moves() ? k->direction.y : T(0);
    }
    forces(0);
  }

  /// Turns the direction of a small slip to where T is r θ′. Returns how far that moves it.
  double settle(Contact<T>& k) {
    const T by = (k.across[0] - k.size * k.turn[0] / unit) / stiffness(k);
    const Vec2<T> d = k.direction + perpendicular(k.direction) * by;
    k.direction = d / norm(d);
    k.fx[0] = k.direction.x;
    k.fy[0] = k.direction.y;
    return as_double(k.size) * magnitude(by);
  }

  /// Computes all coefficients from those of order 0, and from what the pass before says of the turns.
  void pass(int order, double sign) {
    T kappa[2]{};
    if (cushion.slip == Slip::starts) kappa[0] = stiffness(cushion);
    if (cloth.slip == Slip::starts) kappa[1] = stiffness(cloth);
    for (Contact<T>* k : {&cushion, &cloth})
      if (k->slip == Slip::starts && !(as_double(k->size) > 0) && k->along[0] < T(0)) k->along[0] = T(0);
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

  /// Computes all coefficients up to `order`, after begin(). `sign` is that of vy. A slip that starts at r > 0 needs so
  /// many passes that r to that power is below the tolerance. Returns how far the last pass moved it.
  double expand(int order, double sign, double tolerance) {
    double size = 0;
    for (Contact<T>* k : {&cushion, &cloth}) {
      if (k->slip != Slip::starts) continue;
      k->turn.fill(T(0));
      size = std::max(size, as_double(k->size));
    }
    pass(order, sign);
    double moved = 0, left = size;
    while (left > tolerance) {
      left *= size;
      moved = 0;
      for (Contact<T>* k : {&cushion, &cloth})
        if (k->slip == Slip::starts) moved = std::max(moved, settle(*k));
      forces(0);
      pass(order, sign);
    }
    return moved;
  }

  /// Return the slip of contact k (0 cushion, 1 cloth) at σ = x, and its friction impulse per unit of P.
  Vec2<T> slip(std::size_t k, int order, const T& x) const {
    const Contact<T>& c = contact(k);
    const Vec2<T> d{evaluate(c.fx, order, x), evaluate(c.fy, order, x)};
    return d / norm(d) * evaluate(c.r, order, x);
  }
  Vec2<T> friction(std::size_t k, int order, const T& x) const {
    const Contact<T>& c = contact(k);
    return {evaluate(c.ix, order - 1, x), evaluate(c.iy, order - 1, x)};
  }

  /// Returns the size of the terms of order n.
  double term(std::size_t n) const {
    double most = std::max(std::abs(as_double(vy[n])), std::abs(as_double(work[n])));
    for (const Contact<T>* k : {&cushion, &cloth}) {
      if (!k->moves()) continue;
      const bool starts = k->slip == Slip::starts;
      const std::size_t m = starts ? n - 1 : n;
      const double size = starts ? std::abs(as_double(k->r[1])) : as_double(k->size);
      most = std::max(most, std::abs(as_double(k->r[n])));
      most = std::max(most, size * std::max(std::abs(as_double(k->fx[m])), std::abs(as_double(k->fy[m]))));
    }
    return most;
  }

  const Contact<T>& contact(std::size_t k) const { return k == 0 ? cushion : cloth; }
  Contact<T>& contact(std::size_t k) { return k == 0 ? cushion : cloth; }
};

}  // namespace bankshot::detail::mathavan
