// SPDX-License-Identifier: MIT
//
// Results are bit-identical at every optimisation level and on every machine with IEEE doubles, provided the compiler
// neither fuses a product and a sum into one rounding (contraction) nor reorders sums. Much of the simulator is
// templates, which are compiled with the flags of the including program. The CMake targets therefore propagate
// -ffp-contract=off, and this header warns if it is missing.
#pragma once

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
