// SPDX-License-Identifier: MIT
//
// The requirements of the simulator on a scalar T: +, −, ·, /, comparisons and sqrt, found by argument-dependent
// lookup. Three kinds are used: double, a dual number (a value with derivatives: dual.hpp, or a similar type such as
// ceres::Jet), and a number of 50 digits.
//  1. Coefficients of a law are doubles. Their products are formed in Real<T>, so that a run in 50 digits never rounds
//     to double and a dual number is multiplied by plain numbers. A law may also hold dual coefficients, to
//     differentiate by them; these enter a computation in the same dual type unchanged.
//  2. Decisions use value(x). Derivatives never decide anything.
//
// Results are bit-identical at every optimisation level and on every machine with IEEE doubles, provided the compiler
// neither fuses a product and a sum into one rounding (contraction) nor reorders sums. Much of the simulator is
// templates, which are compiled with the flags of the including program. The CMake targets therefore propagate
// -ffp-contract=off, and this header warns if it is missing.
#pragma once

#include <cmath>
#include <type_traits>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "bankshot: -ffast-math and -ffinite-math-only break it: an arc without end lasts infinitely long. Leave them out."
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && !defined(BANKSHOT_CONTRACTION_OFF) && \
    (defined(__FMA__) || defined(__FMA4__) || defined(__ARM_FEATURE_FMA) || defined(__aarch64__))
#warning \
    "bankshot: GCC contracts products and sums here, so results differ in their last bits from those of other \
machines. Link the CMake target bankshot::sim, or compile with -ffp-contract=off -DBANKSHOT_CONTRACTION_OFF."
#endif

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

/// Returns the square root, of any of the three kinds.
template <class T>
T square_root(const T& x) {
  using std::sqrt;
  return sqrt(x);
}

}  // namespace bankshot
