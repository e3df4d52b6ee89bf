// SPDX-License-Identifier: MIT
//
// What the simulator asks of a scalar T: +, −, ·, /, comparisons and sqrt, found by argument-dependent
// lookup. Three kinds are used: double, a dual number (a value with derivatives: dual.hpp, or any that
// looks like it, such as ceres::Jet), and a number of 50 digits.
//  1. Coefficients of a law are doubles; their products are formed in Real<T>, so that in 50 digits
//     nothing is rounded to double on the way, and a dual number is multiplied by plain numbers. Where a law is
//     made of dual coefficients, to derive by them, they enter a computation in the same dual number as such.
//  2. Decisions are taken on value(x): derivatives never decide anything.
#pragma once

#include <type_traits>

#include "bankshot/numbers/contraction.hpp"

namespace bankshot {

/// T without its derivatives. A dual number says what it is made of by the member type Scalar.
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

/// What a coefficient given as C is in a computation in T.
template <class T, class C>
using Coefficient = std::conditional_t<has_derivatives<C>, T, Real<T>>;

/// The value of x, without its derivatives.
template <class T>
const Real<T>& value(const T& x) {
  if constexpr (has_derivatives<T>)
    return value(x.a);
  else
    return x;
}

}  // namespace bankshot
