// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/numbers/scalar.hpp"

namespace bankshot {

/// Restitution e = clamp(at_rest + per_speed · vn + per_speed2 · vn², 0, 1), with the normal approach speed vn [m/s].
template <class C>
struct RestitutionOf {
  C at_rest{0.85};
  C per_speed{0};   ///< s/m
  C per_speed2{0};  ///< s²/m²

  constexpr RestitutionOf() = default;
  constexpr RestitutionOf(const C& constant) : at_rest(constant) {}
  constexpr RestitutionOf(const C& rest, const C& slope, const C& curve = C(0))
      : at_rest(rest), per_speed(slope), per_speed2(curve) {}

  bool operator==(const RestitutionOf&) const = default;

  template <class T>
  T operator()(const T& normal_speed) const {
    if (constant()) return T(at_rest);
    T slope = T(per_speed);
    if (value(per_speed2) != 0) slope = slope + T(per_speed2) * normal_speed;
    const T e = T(at_rest) + slope * normal_speed;
    if (e < T(0)) return T(0);
    return e > T(1) ? T(1) : e;
  }
  /// Returns (1 + e) vn, the change of the approach speed by the cushion.
  template <class T>
  T rebound(const T& normal_speed) const {
    if (constant()) return normal_speed * Coefficient<T, C>(Real<T>(1) + at_rest);
    return normal_speed * (T(1) + (*this)(normal_speed));
  }
  bool constant() const { return value(per_speed) == 0 && value(per_speed2) == 0; }
};
using Restitution = RestitutionOf<double>;

}  // namespace bankshot
