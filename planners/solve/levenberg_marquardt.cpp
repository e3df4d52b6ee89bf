// SPDX-License-Identifier: MIT
//
// Source: Ceres 2.1 tiny_solver.h. Its function_tolerance is compared with the absolute change of the cost, so it is
// set to 0 here.
#include "planners/solve/levenberg_marquardt.hpp"

// The compiler cannot see that TinySolver sets its cost before it reads it.
#ifndef __clang__  // which knows no such warning
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <ceres/tiny_solver.h>

#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::levenberg_marquardt;

/// The residual as TinySolver asks for it: r and, where it is given, the Jacobian, column by column.
template <int N>
struct Residual {
  using Scalar = double;
  enum { NUM_RESIDUALS = N, NUM_PARAMETERS = N };
  const Branch& aim;
  EvaluationBudget& budget;
  double fixed_speed;

  Launch launch(const double* x) const { return {N == 2 ? std::exp(x[N - 1]) : fixed_speed, x[0]}; }

  bool operator()(const double* x, double* r, double* jacobian) const {
    // A path that does not arrive has a flat and high residual, so that the solver turns back or ends.
    const Linear l = linearise(aim, budget, launch(x)).value_or(Linear{.r = {nowhere, nowhere}});
    for (std::size_t k = 0; k < N; ++k) {
      r[k] = l.r[k];
      for (std::size_t i = 0; jacobian && i < N; ++i) jacobian[i * N + k] = l.by[k][i];
    }
    return true;
  }
};

template <int N>
std::optional<Launch> minimise(const Branch& aim, EvaluationBudget& budget, const Launch& seed) {
  const Residual<N> residual{aim, budget, seed.speed};
  ::ceres::TinySolver<Residual<N>> solver;
  solver.options.max_num_iterations = settings::most_steps;
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 0;
  solver.options.parameter_tolerance = settings::rounding;
  solver.options.cost_threshold = exact_cost;
  typename ::ceres::TinySolver<Residual<N>>::Parameters x;
  x(0) = seed.angle;
  if constexpr (N == 2) x(1) = std::log(seed.speed);
  solver.Solve(residual, &x);
  if (!x.allFinite() || !(solver.summary.final_cost < converged_cost)) return {};
  const Launch root = residual.launch(x.data());
  return Launch{root.speed, wrap_angle(root.angle)};
}

}  // namespace

std::optional<Launch> solve_locked(const Branch& aim, EvaluationBudget& budget, const Launch& seed) {
  return aim.request.one_unknown() ? minimise<1>(aim, budget, seed) : minimise<2>(aim, budget, seed);
}

}  // namespace bankshot::planning
