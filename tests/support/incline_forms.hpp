// SPDX-License-Identifier: MIT
//
// Another way to what a ball does on a table that leans: the closed forms of dry friction on an incline, with
// exponentials, where the simulator sums power series in pieces (detail/incline.hpp).
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "bankshot/numbers/vec.hpp"

namespace bankshot::test {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class T>
struct Carried {
  T time;
  Vec2<T> moved, w;  ///< the integral of w, and w
};

/// Friction M on an incline of pull a, not M, e downhill, from w on, to σ; σ < 0, where M > a: to the end. The boost of
/// (|w|, w).
template <class T>
Carried<T> carried(const T& M, const T& a, const Vec2<T>& e, const Vec2<T>& w, const T& sigma) {
  using std::exp;
  const T along = dot(e, w), across = cross(e, w), q = norm(w);
  const bool ends = sigma < T(0);
  const auto left = [&](const T& rate) { return ends ? T(0) : T(exp(T(-rate * sigma))); };
  const auto lost = [&](const T& rate) { return T((T(1) - left(rate)) / rate); };
  const T P = q + along, N = q - along, slow = M - a, fast = M + a;
  const T time = (P * lost(slow) + N * lost(fast)) / 2;
  const T on = P * P / 4 * lost(T(2 * slow)) - N * N / 4 * lost(T(2 * fast));
  const T aside = across / 2 * (P * lost(T(M + slow)) + N * lost(T(M + fast)));
  const T p = P * left(slow), n = N * left(fast), later = (p - n) / 2, beside = across * left(M);
  const auto out = [&](const T& x, const T& y) { return Vec2<T>{e.x * x - e.y * y, e.y * x + e.x * y}; };
  return {time, out(on, aside), out(later, beside)};
}

}  // namespace bankshot::test
