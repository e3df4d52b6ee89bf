// SPDX-License-Identifier: MIT
//
// Real roots of a polynomial of low degree in an interval, for contacts of curved arcs with circles.
// Method: between two neighbouring roots of its derivative, a polynomial is monotone. Each sign change there holds
// exactly one root, found by Newton's method inside a bracket. The derivative's roots are found in the same way, down
// to a line. Nothing is divided by a leading coefficient, since it may vanish.
// Error: a few units in the last place times the root's conditioning.
// Limitation: a double root is found or missed by rounding. With dual numbers, the last Newton step carries the
// derivative of the root (implicit function theorem).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bankshot::detail {

/// c[0] + c[1] t + ... + c[N] t^N
template <class T, int N>
struct Polynomial {
  std::array<T, N + 1> c;

  template <class... A>
  Polynomial(const A&... a) : c{a...} {}

  T operator()(const T& t) const {
    T value = c[N];
    for (int i = N - 1; i >= 0; --i) value = value * t + c[static_cast<std::size_t>(i)];
    return value;
  }
  auto derivative() const {
    Polynomial<T, (N > 0 ? N - 1 : 0)> d;
    for (int i = 1; i <= N; ++i) d.c[static_cast<std::size_t>(i - 1)] = c[static_cast<std::size_t>(i)] * T(i);
    return d;
  }
};

/// A list of up to N values, without allocation.
template <class T, int N>
struct Roots {
  std::array<T, N> values{};
  int count = 0;
  void add(const T& v) { values[static_cast<std::size_t>(count++)] = v; }
  const T* begin() const { return values.data(); }
  const T* end() const { return values.data() + count; }
};

/// Returns the root in [low, high]. f must be monotone there, with different signs at the ends.
template <class T, int N>
T root_in_bracket(const Polynomial<T, N>& f, T low, T high) {
  const auto slope = f.derivative();
  const bool rising = f(high) > T(0);
  T t = low + (high - low) / T(2);
  constexpr int enough = 200;  // more halvings than a bracket of any scalar used here needs
  for (int i = 0; i < enough; ++i) {
    const T value = f(t);
    if (value == T(0)) break;
    ((value > T(0)) == rising ? high : low) = t;
    const T newton = t - value / slope(t);
    const T next = newton > low && newton < high ? newton : T(low + (high - low) / T(2));
    if (next == t || !(low < high)) break;
    const bool settled = next == low || next == high;
    t = next;
    if (settled) break;
  }
  const T s = slope(t);
  return s == T(0) ? t : T(t - f(t) / s);
}

/// Returns all roots in [low, high] at which f changes sign, in order.
template <class T, int N>
Roots<T, N> roots_between(const Polynomial<T, N>& f, const T& low, const T& high) {
  Roots<T, N> out;
  const auto piece = [&](const T& a, const T& b) {
    const T fa = f(a), fb = f(b);
    if ((fa < T(0) && fb > T(0)) || (fa > T(0) && fb < T(0))) out.add(root_in_bracket(f, a, b));
  };
  if constexpr (N == 1) {
    piece(low, high);
  } else {
    T before = low;
    for (const T& turn : roots_between(f.derivative(), low, high)) {
      piece(before, turn);
      before = turn;
    }
    piece(before, high);
  }
  return out;
}

/// Returns the first t in [0, limit] at which f falls through 0, infinity if never. A value of exactly 0 at the start
/// counts if f falls from there.
template <class T, int N>
T first_descent_of(const Polynomial<T, N>& f, const T& limit) {
  if (f.c[0] == T(0) && f.c[1] < T(0)) return T(0);
  T before = T(0);
  const auto falls = [&](const T& a, const T& b) { return f(a) > T(0) && f(b) <= T(0); };
  for (const T& turn : roots_between(f.derivative(), T(0), limit)) {
    if (falls(before, turn)) return root_in_bracket(f, before, turn);
    before = turn;
  }
  if (falls(before, limit)) return root_in_bracket(f, before, limit);
  return T(std::numeric_limits<double>::infinity());
}

}  // namespace bankshot::detail
