// SPDX-License-Identifier: MIT
//
// Results are the same bits at every optimisation level, on every machine with IEEE doubles, as long as no compiler
// joins a product and a sum to one operation with one rounding (contraction), and none reorders sums. Much of the
// simulator is templates, compiled with the flags of whoever includes them: the CMake targets bring
// -ffp-contract=off along, and this header speaks up where it is missing.
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
