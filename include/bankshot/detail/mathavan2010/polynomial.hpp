// SPDX-License-Identifier: MIT
//
// Arithmetic of truncated power series, as the impact of mathavan2010 needs it: product, value, slope,
// root. One source for double, dual numbers and 50 digits; what is decided is decided on the double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace bankshot::mathavan {

/// The number itself, without derivatives or further digits: decisions are taken on it.
template <class T>
double as_double(const T& x) {
  if constexpr (requires { x.a; })
    return static_cast<double>(x.a);
  else
    return static_cast<double>(x);
}

/// What an error estimate sees of x: derivatives, where there are any, to three digits less.
template <class T>
double magnitude(const T& x) {
  double size = as_double(x) < 0 ? -as_double(x) : as_double(x);
  if constexpr (has_derivatives<T>)
    for (std::size_t k = 0; k < sizeof x.v / sizeof(double); ++k)
      size = std::max(size, 1e-3 * (x.v[k] < 0 ? -x.v[k] : x.v[k]));
  return size;
}

/// Tolerances below the rounding of double need more terms than it, or a dual number, can use.
template <class T>
inline constexpr int max_order = has_derivatives<T> || std::is_same_v<T, double> ? 28 : 48;

template <class T>
using Series = std::array<T, max_order<T> + 1>;

/// Coefficient n of a·b, without the first `from` terms of a and the first `skip` of b.
template <class T>
T product(const Series<T>& a, const Series<T>& b, int n, int from = 0, int skip = 0) {
  T sum(0);
  for (int j = from; j <= n - skip; ++j) sum += a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(n - j)];
  return sum;
}

template <class T>
T evaluate(const Series<T>& a, int order, const T& x) {
  T sum = a[static_cast<std::size_t>(order)];
  for (int j = order; j-- > 0;) sum = sum * x + a[static_cast<std::size_t>(j)];
  return sum;
}

/// The same of member k of a series of pairs.
template <class S, class T>
T evaluate(const S& a, std::size_t k, int order, const T& x) {
  T sum = a[static_cast<std::size_t>(order)][k];
  for (int j = order; j-- > 0;) sum = sum * x + a[static_cast<std::size_t>(j)][k];
  return sum;
}

template <class T>
T slope(const Series<T>& a, int order, const T& x) {
  T sum = a[static_cast<std::size_t>(order)] * T(order);
  for (int j = order; j-- > 1;) sum = sum * x + a[static_cast<std::size_t>(j)] * T(j);
  return sum;
}

/// Root in (0, length] of a polynomial minus `goal`, which it passes once there; Newton, bracketed. `off`
/// is the error allowed, relative to the length.
template <class T>
T root(const Series<T>& a, int order, const T& goal, double length, double off) {
  double low = 0, high = length;
  T x(length);
  const bool rises = as_double(goal) > as_double(a[0]);
  constexpr int most = 100;
  bool last = false;
  for (int i = 0; i < most; ++i) {
    const T miss = evaluate(a, order, x) - goal;
    ((as_double(miss) > 0) == rises ? high : low) = as_double(x);
    T next = x - miss / slope(a, order, x);
    const double v = as_double(next);
    // Near the root the bracket, kept in double, says no more.
    constexpr double near = 1e-10;
    if (!(v > low && v < high) && !(std::abs(v - as_double(x)) <= near * length)) next = T((low + high) / 2);
    const double moved = std::abs(as_double(T(next - x)));
    x = next;
    if (last) return x;
    last = moved * moved <= off * length * length;
  }
  return x;
}

/// The end of the interval outside, to the last bit, of a change from outside(0) = false.
template <class F>
double first_outside(double length, const F& outside) {
  double low = 0, high = length;
  constexpr double fine = 1e-15;
  while (high - low > fine * length) {
    const double middle = (low + high) / 2;
    (outside(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace bankshot::mathavan
