// SPDX-License-Identifier: MIT
//
// Arithmetic of truncated power series, as the impact of mathavan2010 needs it: product, value, slope, root. One source
// serves double, dual numbers and 50 digits. Decisions are taken on the double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "bankshot/numbers/scalar.hpp"

namespace bankshot::detail::mathavan {

/// Returns the number itself, without derivatives or further digits. Decisions are taken on it.
template <class T>
double as_double(const T& x) {
  if constexpr (requires { x.a; })
    return static_cast<double>(x.a);
  else
    return static_cast<double>(x);
}

/// Returns the size of x for an error estimate. Derivatives, if there are any, count a thousandth.
template <class T>
double magnitude(const T& x) {
  double size = as_double(x) < 0 ? -as_double(x) : as_double(x);
  if constexpr (has_derivatives<T>)
    for (std::size_t k = 0; k < sizeof x.v / sizeof(double); ++k)
      size = std::max(size, 1e-3 * (x.v[k] < 0 ? -x.v[k] : x.v[k]));
  return size;
}

/// Highest order of a series. A tolerance below the rounding of double needs more terms than a double or a dual number
/// can use.
template <class T>
inline constexpr int max_order = has_derivatives<T> || std::is_same_v<T, double> ? 28 : 48;

template <class T>
using Series = std::array<T, max_order<T> + 1>;

/// Returns coefficient n of a·b, without the first `from` terms of a and the first `skip` of b.
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

/// Evaluates member k of a series of pairs.
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

/// Returns the root in (0, length] of a polynomial minus `goal`, which it passes once there. Uses Newton's method in a
/// bracket. `off` is the error allowed, relative to the length.
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
    // Near the root, the bracket is too coarse to decide, since it is kept in double.
    constexpr double near = 1e-10;
    if (!(v > low && v < high) && !(std::abs(v - as_double(x)) <= near * length)) next = T((low + high) / 2);
    const double moved = std::abs(as_double(T(next - x)));
    x = next;
    if (last) return x;
    last = moved * moved <= off * length * length;
  }
  return x;
}

/// Finds, to the last bit, where `outside` changes from false at 0 to true. Returns the end of the bracket that is
/// outside.
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

}  // namespace bankshot::detail::mathavan
