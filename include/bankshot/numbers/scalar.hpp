// SPDX-License-Identifier: MIT
//
// The requirements of the simulator on a scalar T: +, −, ·, /, comparisons and sqrt, found by argument-dependent
// lookup. Three kinds are used: double, a dual number (a value with derivatives: dual.hpp, or a similar type such as
// ceres::Jet), and a number of 50 digits.
//  1. Coefficients of a law are doubles. Their products are formed in Real<T>, so that a run in 50 digits never rounds
//     to double and a dual number is multiplied by plain numbers. A law may also hold dual coefficients, to
//     differentiate by them; these enter a computation in the same dual type unchanged.
//  2. Decisions use value(x). Derivatives never decide anything.
#pragma once

#include <type_traits>

#include "bankshot/numbers/contraction.hpp"

namespace bankshot {

/// T without its derivatives. A dual number names its underlying type by the member type Scalar.
template <class T>
struct RealOf {
  using type = T;
};
template <class T>
requires requires { typename T::Scalar; }
struct RealOf<T> {
  using type = typename RealOf<typename T::Scalar>::type;
};
template <class T>
using Real = typename RealOf<T>::type;

template <class T>
inline constexpr bool has_derivatives = !std::is_same_v<T, Real<T>>;

/// The type that a coefficient of type C has in a computation in T.
template <class T, class C>
using Coefficient = std::conditional_t<has_derivatives<C>, T, Real<T>>;

/// Returns the value of x, without its derivatives.
template <class T>
const Real<T>& value(const T& x) {
  if constexpr (has_derivatives<T>)
    return value(x.a);
  else
    return x;
}

}  // namespace bankshot
