// SPDX-License-Identifier: MIT
//
// One step of the cushion impact of Mathavan, Jackson & Parkin (2010) as Taylor series, where every slip either stays 0
// or is well away from 0. The smaller a slip, the faster its direction turns. The variable is therefore a clock σ that
// slows down with one of the slips: dP = unit (r / r0) dσ. For the slip w = (x, y), its size r and its direction f, the
// recurrences are w′ = a dP/dσ (a from law.hpp), r′ = f·w′ and r f = w. vy needs none, because vy (1 + sin θ) is the
// difference of the two slips along y.
//
// Both contacts are computed side by side, which a compiler turns into one instruction for two. All sums over earlier
// coefficients share one loop, so that they do not wait for each other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "bankshot/detail/mathavan2010/law.hpp"
#include "bankshot/detail/mathavan2010/pair.hpp"
#include "bankshot/detail/mathavan2010/polynomial.hpp"

namespace bankshot::detail::mathavan {

template <class T>
using PairSeries = std::array<Pair<T>, max_order<T> + 1>;

template <class T>
struct Slide {
  PairSeries<T> x, y, r, fx, fy;  ///< slips, their sizes and directions
  PairSeries<T> ix, iy;           ///< friction impulses per unit of P
  Series<T> q, vy, work;

  /// Computes all coefficients up to `order`, from coefficients 0 of x, y, r, fx, fy, vy and work. The slip at the
  /// cushion (`clock` 0) or at the cloth (1) drives the clock.
  void expand(const Nose<T>& nose, const Sliding& slides, int order, std::size_t clock, const T& unit, int sign) {
    const T by_sum = T(1) / (T(1) + nose.sine), work_rate = T(sign) * nose.cosine;
    const Pair<T> by_size{slides.cushion ? T(1) / r[0][0] : T(0), slides.cloth ? T(1) / r[0][1] : T(0)};
    const T by_clock = unit * by_size[clock];
    pace_[0] = unit;
    for (std::size_t n = 0; n < static_cast<std::size_t>(order); ++n) {
      const Sums s = earlier(n);
      if (n > 0) turn(n, s, by_size);
      push(nose, slides, n, s);
      pull(n, s);
      const T by = T(1) / T(static_cast<int>(n + 1));
      Pair<T> along = s.fp + (px_[n] * fx[0] + py_[n] * fy[0]);
      if (n > 0) along = along + (px_[0] * fx[n] + py_[0] * fy[n]);
      x[n + 1] = by * px_[n];
      y[n + 1] = by * py_[n];
      r[n + 1] = by * along;
      T energy = s.pvy + pace_[0] * vy[n];
      if (n > 0) energy += pace_[n] * vy[0];
      work[n + 1] = by * work_rate * energy;
      vy[n + 1] = (y[n + 1][1] - y[n + 1][0]) * by_sum;
      pace_[n + 1] = by_clock * r[n + 1][clock];
    }
  }

  /// Return the slip of contact k (0 cushion, 1 cloth) at σ = `at`, and its friction impulse per unit of P.
  Vec2<T> slip(std::size_t k, int order, const T& at) const {
    return {evaluate(x, k, order, at), evaluate(y, k, order, at)};
  }
  Vec2<T> friction(std::size_t k, int order, const T& at) const {
    return {evaluate(ix, k, order - 1, at), evaluate(iy, k, order - 1, at)};
  }

  /// Returns the size of the terms of order n.
  double term(std::size_t n) const {
    double most = std::max(std::abs(as_double(vy[n])), std::abs(as_double(work[n])));
    for (std::size_t k = 0; k < 2; ++k)
      most = std::max({most, std::abs(as_double(x[n][k])), std::abs(as_double(y[n][k]))});
    return most;
  }

 private:
  PairSeries<T> ax_, ay_, px_, py_;  ///< rates of the slips with P and with σ
  PairSeries<T> cloth_;              ///< direction of the slip at the cloth: x, y
  Series<T> pace_;                   ///< dP/dσ

  /// Part of coefficient n of the products that comes from coefficients 1 to n − 1.
  struct Sums {
    Pair<T> rfx{T(0), T(0)}, rfy{T(0), T(0)};  ///< r f
    Pair<T> pax{T(0), T(0)}, pay{T(0), T(0)};  ///< a dP/dσ
    Pair<T> fp{T(0), T(0)};                    ///< f·w′
    Pair<T> qf{T(0), T(0)};                    ///< q f at the cloth: x, y
    T pvy{0};                                  ///< vy dP/dσ
  };

  Sums earlier(std::size_t n) const {
    Sums s;
    for (std::size_t j = 1; j < n; ++j) {
      const std::size_t i = n - j;
      s.rfx = s.rfx + r[j] * fx[i];
      s.rfy = s.rfy + r[j] * fy[i];
      s.pax = s.pax + pace_[j] * ax_[i];
      s.pay = s.pay + pace_[j] * ay_[i];
      s.fp = s.fp + (px_[j] * fx[i] + py_[j] * fy[i]);
      s.qf = s.qf + q[j] * cloth_[i];
      s.pvy += pace_[j] * vy[i];
    }
    return s;
  }

  /// Computes coefficient n > 0 of the directions.
  void turn(std::size_t n, const Sums& s, const Pair<T>& by_size) {
    fx[n] = (x[n] - s.rfx - r[n] * fx[0]) * by_size;
    fy[n] = (y[n] - s.rfy - r[n] * fy[0]) * by_size;
  }

  /// Computes coefficient n of the forces.
  void push(const Nose<T>& nose, const Sliding& slides, std::size_t n, const Sums& s) {
    cloth_[n] = {fx[n][1], fy[n][1]};
    T known(0);
    if (!slides.cushion)
      for (std::size_t j = 1; j <= n; ++j) known += cloth_[j][1] * iy[n - j][0];
    const auto times_load = [&](const T& load) {
      Vec2<T> f{s.qf[0] + load * cloth_[0][0], s.qf[1] + load * cloth_[0][1]};
      if (n > 0) f += {q[0] * cloth_[n][0], q[0] * cloth_[n][1]};
      return f;
    };
    const Forces<T> f = forces<T>(nose, slides, n == 0 ? T(1) : T(0), {fx[n][0], fy[n][0]}, {fx[n][1], fy[n][1]},
                                  cloth_[0][1], known, times_load);
    q[n] = f.load;
    ix[n] = {f.cushion.x, f.cloth.x};
    iy[n] = {f.cushion.y, f.cloth.y};
    ax_[n] = {slides.cushion ? f.cushion_rate.x : T(0), slides.cloth ? f.cloth_rate.x : T(0)};
    ay_[n] = {slides.cushion ? f.cushion_rate.y : T(0), slides.cloth ? f.cloth_rate.y : T(0)};
  }

  /// Computes coefficient n of the rates with σ.
  void pull(std::size_t n, const Sums& s) {
    px_[n] = s.pax + pace_[0] * ax_[n];
    py_[n] = s.pay + pace_[0] * ay_[n];
    if (n == 0) return;
    px_[n] = px_[n] + pace_[n] * ax_[0];
    py_[n] = py_[n] + pace_[n] * ay_[0];
  }
};

}  // namespace bankshot::detail::mathavan
