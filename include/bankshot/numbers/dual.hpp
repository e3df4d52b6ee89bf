// SPDX-License-Identifier: MIT
//
// A dual number holds a value and its derivatives by N variables, which every operation carries along exactly (forward
// mode of automatic differentiation). It can stand for any scalar T (numbers/scalar.hpp) to obtain derivatives.
//   Dual<2> x(3.0, 0), y(4.0, 1);   // variables 0 and 1
//   Dual<2> z = sqrt(x * x + y * y);  // z.a = 5, z.v = {0.6, 0.8}
// The operations round in the same order as ceres::Jet (Ceres 2.1, jet.h), so both give the same bits. Comparisons use
// the value alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace bankshot {

/// Two derivatives as one vector, because compilers do not vectorise them by themselves.
typedef double Pair __attribute__((vector_size(2 * sizeof(double))));

template <int N>
struct DerivativesOf {
  using type = std::array<double, N>;
};
template <>
struct DerivativesOf<2> {
  using type = Pair;
};
template <int N>
using Derivatives = typename DerivativesOf<N>::type;

template <int N>
struct Dual {
  using Scalar = double;

  double a = 0;  ///< the value
  /// The derivative by each variable. A pair is aligned and copied whole: reading it across two separately copied
  /// halves would stall.
  Derivatives<N> v{};

  constexpr Dual() = default;
  explicit constexpr Dual(double value) : a(value) {}
  /// Makes variable number k.
  constexpr Dual(double value, int k) : a(value) { v[static_cast<std::size_t>(k)] = 1; }

  friend Dual operator+(const Dual& f) { return f; }
  friend Dual operator-(const Dual& f) {
    return each(-f.a, f, f, [](auto df, auto) { return -df; });
  }

  friend Dual operator+(const Dual& f, const Dual& g) {
    return each(f.a + g.a, f, g, [](auto df, auto dg) { return df + dg; });
  }
  friend Dual operator-(const Dual& f, const Dual& g) {
    return each(f.a - g.a, f, g, [](auto df, auto dg) { return df - dg; });
  }
  friend Dual operator*(const Dual& f, const Dual& g) {
    return each(f.a * g.a, f, g, [&](auto df, auto dg) { return f.a * dg + df * g.a; });
  }
  friend Dual operator/(const Dual& f, const Dual& g) {
    const double inverse = 1 / g.a, ratio = f.a * inverse;
    return each(ratio, f, g, [&](auto df, auto dg) { return (df - ratio * dg) * inverse; });
  }

  friend Dual operator+(Dual f, double s) { return f.a += s, f; }
  friend Dual operator+(double s, Dual f) { return f.a += s, f; }
  friend Dual operator-(Dual f, double s) { return f.a -= s, f; }
  friend Dual operator-(double s, const Dual& f) {
    return each(s - f.a, f, f, [](auto df, auto) { return -df; });
  }
  friend Dual operator*(const Dual& f, double s) { return f.through(f.a * s, s); }
  friend Dual operator*(double s, const Dual& f) { return f.through(f.a * s, s); }
  friend Dual operator/(const Dual& f, double s) { return f * (1 / s); }
  friend Dual operator/(double s, const Dual& g) { return g.through(s / g.a, -s / (g.a * g.a)); }

  Dual& operator+=(const Dual& g) { return *this = *this + g; }
  Dual& operator-=(const Dual& g) { return *this = *this - g; }
  Dual& operator*=(const Dual& g) { return *this = *this * g; }
  Dual& operator/=(const Dual& g) { return *this = *this / g; }
  Dual& operator+=(double s) { return *this = *this + s; }
  Dual& operator-=(double s) { return *this = *this - s; }
  Dual& operator*=(double s) { return *this = *this * s; }
  Dual& operator/=(double s) { return *this = *this / s; }

  // The comparisons are written out because compilers turn <=> of doubles into slower code.
  friend bool operator==(const Dual& f, const Dual& g) { return f.a == g.a; }
  friend bool operator<(const Dual& f, const Dual& g) { return f.a < g.a; }
  friend bool operator>(const Dual& f, const Dual& g) { return f.a > g.a; }
  friend bool operator<=(const Dual& f, const Dual& g) { return f.a <= g.a; }
  friend bool operator>=(const Dual& f, const Dual& g) { return f.a >= g.a; }
  friend bool operator==(const Dual& f, double s) { return f.a == s; }
  friend bool operator<(const Dual& f, double s) { return f.a < s; }
  friend bool operator>(const Dual& f, double s) { return f.a > s; }
  friend bool operator<=(const Dual& f, double s) { return f.a <= s; }
  friend bool operator>=(const Dual& f, double s) { return f.a >= s; }
  friend bool operator<(double s, const Dual& f) { return s < f.a; }
  friend bool operator>(double s, const Dual& f) { return s > f.a; }
  friend bool operator<=(double s, const Dual& f) { return s <= f.a; }
  friend bool operator>=(double s, const Dual& f) { return s >= f.a; }

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
  /// Returns a number with this value, and with derivatives computed from those of f and g by one rule.
  template <class Rule>
  static Dual each(double value, const Dual& f, const Dual& g, Rule&& rule) {
    Dual out(value);
    if constexpr (N == 2)
      out.v = rule(f.v, g.v);
    else
      for (std::size_t k = 0; k < N; ++k) out.v[k] = rule(f.v[k], g.v[k]);
    return out;
  }

  /// Applies a function with this value and slope (chain rule).
  Dual through(double value, double slope) const {
    return each(value, *this, *this, [&](auto d, auto) { return d * slope; });
  }
};

}  // namespace bankshot
