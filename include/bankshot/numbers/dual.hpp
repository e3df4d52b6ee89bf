// SPDX-License-Identifier: MIT
//
// A number with its derivatives by N variables, carried along exactly through every operation (forward mode of
// automatic differentiation). Where a scalar T may be anything (numbers/scalar.hpp), this gives derivatives.
//   Dual<2> x(3.0, 0), y(4.0, 1);   // the variables number 0 and 1
//   Dual<2> z = sqrt(x * x + y * y);  // z.a = 5, z.v = {0.6, 0.8}
// The operations round in the order of ceres::Jet (Ceres 2.1, jet.h), so both give the same bits; comparisons look at
// the value alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace bankshot {

template <int N>
struct Dual {
  using Scalar = double;

  double a = 0;               ///< the value
  std::array<double, N> v{};  ///< its derivative by each variable

  constexpr Dual() = default;
  explicit constexpr Dual(double value) : a(value) {}
  /// The variable number k.
  constexpr Dual(double value, int k) : a(value) { v[static_cast<std::size_t>(k)] = 1; }

  /// A value, and derivatives made one by one.
  template <class Derivative>
  static constexpr Dual make(double value, Derivative&& derivative) {
    Dual out;
    out.a = value;
    for (std::size_t k = 0; k < N; ++k) out.v[k] = derivative(k);
    return out;
  }

  friend constexpr Dual operator+(const Dual& f) { return f; }
  friend constexpr Dual operator-(const Dual& f) {
    return make(-f.a, [&](std::size_t k) { return -f.v[k]; });
  }

  friend constexpr Dual operator+(const Dual& f, const Dual& g) {
    return make(f.a + g.a, [&](std::size_t k) { return f.v[k] + g.v[k]; });
  }
  friend constexpr Dual operator-(const Dual& f, const Dual& g) {
    return make(f.a - g.a, [&](std::size_t k) { return f.v[k] - g.v[k]; });
  }
  friend constexpr Dual operator*(const Dual& f, const Dual& g) {
    return make(f.a * g.a, [&](std::size_t k) { return f.a * g.v[k] + f.v[k] * g.a; });
  }
  friend constexpr Dual operator/(const Dual& f, const Dual& g) {
    const double inverse = 1 / g.a, ratio = f.a * inverse;
    return make(ratio, [&](std::size_t k) { return (f.v[k] - ratio * g.v[k]) * inverse; });
  }

  friend constexpr Dual operator+(Dual f, double s) { return f.a += s, f; }
  friend constexpr Dual operator+(double s, Dual f) { return f.a += s, f; }
  friend constexpr Dual operator-(Dual f, double s) { return f.a -= s, f; }
  friend constexpr Dual operator-(double s, const Dual& f) {
    return make(s - f.a, [&](std::size_t k) { return -f.v[k]; });
  }
  friend constexpr Dual operator*(const Dual& f, double s) {
    return make(f.a * s, [&](std::size_t k) { return f.v[k] * s; });
  }
  friend constexpr Dual operator*(double s, const Dual& f) { return f * s; }
  friend constexpr Dual operator/(const Dual& f, double s) { return f * (1 / s); }
  friend constexpr Dual operator/(double s, const Dual& g) {
    const double slope = -s / (g.a * g.a);
    return make(s / g.a, [&](std::size_t k) { return g.v[k] * slope; });
  }

  constexpr Dual& operator+=(const Dual& g) { return *this = *this + g; }
  constexpr Dual& operator-=(const Dual& g) { return *this = *this - g; }
  constexpr Dual& operator*=(const Dual& g) { return *this = *this * g; }
  constexpr Dual& operator/=(const Dual& g) { return *this = *this / g; }
  constexpr Dual& operator+=(double s) { return *this = *this + s; }
  constexpr Dual& operator-=(double s) { return *this = *this - s; }
  constexpr Dual& operator*=(double s) { return *this = *this * s; }
  constexpr Dual& operator/=(double s) { return *this = *this / s; }

  // Written out: compilers turn <=> of doubles into slower code.
  friend constexpr bool operator==(const Dual& f, const Dual& g) { return f.a == g.a; }
  friend constexpr bool operator<(const Dual& f, const Dual& g) { return f.a < g.a; }
  friend constexpr bool operator>(const Dual& f, const Dual& g) { return f.a > g.a; }
  friend constexpr bool operator<=(const Dual& f, const Dual& g) { return f.a <= g.a; }
  friend constexpr bool operator>=(const Dual& f, const Dual& g) { return f.a >= g.a; }
  friend constexpr bool operator==(const Dual& f, double s) { return f.a == s; }
  friend constexpr bool operator<(const Dual& f, double s) { return f.a < s; }
  friend constexpr bool operator>(const Dual& f, double s) { return f.a > s; }
  friend constexpr bool operator<=(const Dual& f, double s) { return f.a <= s; }
  friend constexpr bool operator>=(const Dual& f, double s) { return f.a >= s; }
  friend constexpr bool operator<(double s, const Dual& f) { return s < f.a; }
  friend constexpr bool operator>(double s, const Dual& f) { return s > f.a; }
  friend constexpr bool operator<=(double s, const Dual& f) { return s <= f.a; }
  friend constexpr bool operator>=(double s, const Dual& f) { return s >= f.a; }

  friend Dual sqrt(const Dual& f) {
    const double root = std::sqrt(f.a);
    return f.through(root, 1 / (2 * root));
  }
  friend Dual abs(const Dual& f) { return f.through(std::abs(f.a), std::copysign(1.0, f.a)); }
  friend Dual exp(const Dual& f) {
    const double power = std::exp(f.a);
    return f.through(power, power);
  }
  friend Dual log(const Dual& f) { return f.through(std::log(f.a), 1 / f.a); }
  friend Dual sin(const Dual& f) { return f.through(std::sin(f.a), std::cos(f.a)); }
  friend Dual cos(const Dual& f) { return f.through(std::cos(f.a), -std::sin(f.a)); }

 private:
  /// A function's value, and its slope here.
  constexpr Dual through(double value, double slope) const {
    return make(value, [&](std::size_t k) { return v[k] * slope; });
  }
};

}  // namespace bankshot
