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

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/dual.hpp"
#include "planners/settings.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning {
namespace {

/// The residual as TinySolver asks for it: r and, where it is given, the Jacobian, column by column.
template <int N>
struct Residual {
  using Scalar = double;
  enum { NUM_RESIDUALS = N, NUM_PARAMETERS = N };
  const Branch& aim;
  double fixed_speed;
  Work& work;

  bool operator()(const double* x, double* r, double* jacobian) const {
    if (!jacobian) return evaluate(x, r);
    Dual<N> at[N], dual[N];
    for (int i = 0; i < N; ++i) at[i] = Dual<N>(x[i], i);
    evaluate(at, dual);
    for (int k = 0; k < N; ++k) {
      r[k] = dual[k].a;
      for (int i = 0; i < N; ++i) jacobian[i * N + k] = dual[k].v[static_cast<std::size_t>(i)];
    }
    return true;
  }

 private:
  template <class T>
  bool evaluate(const T* x, T* r) const {
    using std::exp;
    const T speed = N == 2 ? T(exp(x[N - 1])) : T(fixed_speed);
    const auto arrival = arrival_of(aim, start_of(aim.request, x[0], speed), aim.request.puzzle().physics, work);
    if (!arrival || !residuals_of<N>(aim, *arrival, r))
      std::fill(r, r + N, T(settings::levenberg_marquardt::nowhere));  // flat and high: it turns back or gives up
    return true;
  }
};

template <int N>
std::optional<Launch> minimise(const Branch& aim, EvaluationBudget& budget, const Launch& seed) {
  using namespace settings::levenberg_marquardt;
  const Residual<N> residual{aim, seed.speed, budget.work()};
  ::ceres::TinySolver<Residual<N>> solver;
  if (budget.spent()) return {};
  // The solver costs one simulation, and two for each iteration.
  const auto affordable = (budget.left() - 1) / 2 / (1 + static_cast<long>(aim.route.size() / bounces_a_simulation));
  solver.options.max_num_iterations = static_cast<int>(std::min<long>(settings::most_steps, affordable));
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 0;
  solver.options.parameter_tolerance = settings::rounding;
  solver.options.cost_threshold = exact_cost;
  typename ::ceres::TinySolver<Residual<N>>::Parameters x;
  x(0) = seed.angle;
  if constexpr (N == 2) x(1) = std::log(seed.speed);
  solver.Solve(residual, &x);
  budget.charge(aim.route.size(), 1 + 2 * solver.summary.iterations);
  if (!x.allFinite() || !(solver.summary.final_cost < converged_cost)) return {};
  double speed = seed.speed;
  if constexpr (N == 2) speed = std::exp(x(1));
  return Launch{speed, wrap_angle(x(0))};
}

}  // namespace

std::optional<Launch> solve_locked(const Branch& aim, EvaluationBudget& budget, const Launch& seed) {
  return aim.request.one_unknown() ? minimise<1>(aim, budget, seed) : minimise<2>(aim, budget, seed);
}

std::optional<Launch> refine(const SearchRequest& request, EvaluationBudget& budget, const Launch& seed,
                             const Route& route) {
  std::optional<Launch> best;
  double least = std::numeric_limits<double>::infinity();
  for (const AimPoint& aim_point : request.problem->aim_points) {
    const auto x = solve_locked({request, route, aim_point}, budget, seed);
    if (!x) continue;
    const double moved = std::abs(angle_difference(x->angle, seed.angle));
    if (moved < least) best = x, least = moved;
  }
  return best;
}

}  // namespace bankshot::planning
