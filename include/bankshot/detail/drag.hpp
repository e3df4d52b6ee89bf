// SPDX-License-Identifier: MIT
//
// Rolling friction that grows with speed, μr = a + b v. The ball moves along a straight line by a clock of its own.
//   v̇ = −(A + B v), A = a g [m/s²], B = b g [1/s]
//   v(t) = (v0 + A/B) e^{−Bt} − A/B,  rest after ln(1 + B v0/A)/B seconds
//   s(v) = (v0 − v)/B − (A/B²) ln((A + B v0)/(A + B v))
// The code uses x = B (v0 − v)/(A + B v) and x − ln(1 + x), so that nothing cancels as B → 0, where s = (v0² − v²)/2A.
// Error: a few units in the last place.
#pragma once

#include <cmath>
#include <limits>

#include "bankshot/numbers/scalar.hpp"

namespace bankshot::detail {

/// Largest argument for which series are summed. Beyond it, the closed forms lose at most two bits to cancellation.
inline constexpr double where_series_converge = 1;
inline constexpr int most_terms = 200;

/// Returns x − ln(1 + x) to full relative precision. With u = x/(2 + x) it is x u − 2 (u³/3 + u⁵/5 + ...).
template <class T>
T minus_log1p(const T& x) {
  using std::abs, std::log;
  if (abs(value(x)) > where_series_converge) return x - log(x + 1.0);
  const T u = x / (x + 2.0), u2 = u * u;
  T power = u * u2 * 2.0, sum = x * u;
  for (int n = 3; n < most_terms && abs(value(power)) > std::numeric_limits<Real<T>>::epsilon() * value(sum); n += 2) {
    sum -= power / static_cast<double>(n);
    power *= u2;
  }
  return sum;
}

/// Returns (y − 1 + e^{−y}) / y² for y >= 0, also to full relative precision.
template <class T>
T exponential_rest(const T& y) {
  using std::abs, std::exp;
  if (value(y) > where_series_converge) return (y - 1.0 + exp(-y)) / (y * y);
  T term = T(0.5), sum = term;
  for (int n = 3; n < most_terms && abs(value(term)) > std::numeric_limits<Real<T>>::epsilon(); ++n) {
    term *= -y / static_cast<double>(n);
    sum += term;
  }
  return sum;
}

template <class N>
struct Drag {
  N constant{0};  ///< A [m/s²], > 0 where linear is not 0
  N linear{0};    ///< B [1/s], >= 0; 0: no drag, an ordinary arc

  bool none() const { return value(linear) == 0; }

  /// Returns the distance rolled while slowing from v0 to v [m].
  template <class T>
  T length(const T& v0, const T& v) const {
    const T x = (v0 - v) * linear / (v * linear + constant);
    return (minus_log1p(x) * constant + x * v * linear) / (linear * linear);
  }

  /// Returns the time to slow from v0 to v [s].
  template <class T>
  T seconds(const T& v0, const T& v) const {
    const T x = (v0 - v) * linear / (v * linear + constant);
    using std::log;
    return (value(x) > where_series_converge ? T(log(x + 1.0)) : T(x - minus_log1p(x))) / linear;
  }

  /// Returns the speed after s metres. Uses Newton's method in v², of which s is nearly linear, inside a bracket. Near
  /// rest the rounding of s is more than a step, and the bracket closes on the root instead. One last step, whose value
  /// is left out, gives the derivatives.
  template <class T>
  T speed_after(const T& v0, const T& s) const {
    using std::abs;
    if (!(value(s) < value(length(v0, T(0))))) return T(0);
    const T first = v0 - s * linear;  // exact without the constant part, else too fast
    T square = value(first) > 0 ? T(first * first) : T(0);
    using Number = Real<T>;
    const Number start2 = value(v0) * value(v0), slowing = value(v0) * value(linear) + value(constant);
    Number low(0), high = value(s) > 0 ? start2 : Number(2 * (start2 - value(s) * slowing));
    constexpr int enough = 200;
    for (int i = 0; i < enough; ++i) {
      const T v = root_of(square), beyond = length(v0, v) - s;
      (value(beyond) > 0 ? low : high) = value(square);
      const T step = beyond * (v * linear + constant) * 2.0;
      const T next = square + step;
      const bool inside = value(next) > low && value(next) < high;
      const bool settled = !(abs(value(step)) > 4 * std::numeric_limits<Number>::epsilon() * value(square));
      square = inside || settled ? next : T((low + high) / 2);
      const bool closed = !inside && !(value(square) > low && value(square) < high);
      if (settled || closed) break;
    }
    if constexpr (has_derivatives<T>) {
      square = T(value(square));
      const T v = root_of(square), beyond = length(v0, v) - s;
      square += (beyond - value(beyond)) * (2 * (value(v) * value(linear) + value(constant)));
    }
    return root_of(square);
  }

  /// Returns the distance rolled in t seconds [m]. The ball must not rest before.
  template <class T>
  T length_in(const T& v0, const T& t) const {
    const T y = t * linear, rest = exponential_rest(y);
    return v0 * t * (T(1) - y * rest) - t * t * rest * constant;
  }

 private:
  template <class T>
  static T root_of(const T& square) {
    using std::sqrt;
    return value(square) > 0 ? T(sqrt(square)) : T(0);
  }
};

}  // namespace bankshot::detail
