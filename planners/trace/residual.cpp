// SPDX-License-Identifier: MIT
#include "planners/trace/residual.hpp"

#include <algorithm>

#include "bankshot/numbers/dual.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning {
namespace {

template <int N>
std::optional<Linear> linearise(const Branch& aim, const Launch& launch, const Physics& physics, Work& work) {
  using DualN = Dual<N>;
  const auto arrival = arrival_of(aim, dual_start<DualN, N>(aim.request, launch, aim.request.spin), physics, work);
  DualN r[N];
  if (!arrival || !residuals_of<N>(aim, *arrival, r)) return {};
  return linear<N>(r, arrival->time.a);
}

}  // namespace

std::optional<Linear> linearise(const Branch& aim, EvaluationBudget& budget, const Launch& launch, bool roughly) {
  if (budget.spent()) return {};
  budget.charge(aim.route.size());
  const Physics& physics = roughly ? aim.request.problem->rough : aim.request.puzzle().physics;
  return aim.request.one_unknown() ? linearise<1>(aim, launch, physics, budget.work())
                                   : linearise<2>(aim, launch, physics, budget.work());
}

std::optional<double> excess_speed2(const Branch& aim, EvaluationBudget& budget, double angle, double square) {
  if (budget.spent()) return {};
  budget.charge(aim.route.size());
  const auto arrival =
      arrival_of(aim, start_of(aim.request, angle, std::sqrt(square)), aim.request.problem->rough, budget.work());
  if (!arrival) return {};
  const Physics& physics = aim.request.puzzle().physics;
  const double asked = even_square(physics, aim.request.asked * aim.request.asked);
  const Vec2d& v = arrival->state.velocity;
  if (!arrival->at_rest) return even_square(physics, dot(v, v)) - asked;
  const double short_of = dot(arrival->heading, aim.aim_point.at - arrival->state.at) / norm(arrival->heading);
  return -2 * deceleration(physics) * short_of - asked;
}

}  // namespace bankshot::planning
