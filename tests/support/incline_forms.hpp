// SPDX-License-Identifier: MIT
//
// An independent solution of the motion on a tilted table: the closed forms of dry friction on an incline, with
// exponentials. The simulator sums power series in pieces instead (detail/incline.hpp).
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "bankshot/numbers/vec.hpp"

namespace bankshot::test {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class T>
struct Carried {
  T time;
  Vec2<T> moved, w;  ///< the integral of w, and w at the end
};

/// Carries w along an incline with friction M and downhill pull a != M in the direction e, up to σ. A negative σ, where
/// M > a, means to the end. (|w|, w) is carried by a boost.
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
