// SPDX-License-Identifier: MIT
#include "planners/solve/made_as_asked.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

double square(double x) { return x * x; }

/// Returns the arrival speed to aim for [m/s], from the one in hand.
double wanted(const SearchRequest& request, double arrived) {
  return request.arrival->fixed() ? request.asked : std::clamp(arrived, request.arrival->low, request.arrival->high);
}

/// Returns whether a launch arrives as fast as asked, or as the launch speed lets it.
bool as_fast(const SearchRequest& request, double arrived) {
  if (request.one_unknown() || request.stop) return true;
  const double fine = tolerance::exact_speed * std::max(1.0, request.asked) / 4;
  return std::abs(arrived - wanted(request, arrived)) <= fine;
}

}  // namespace

std::optional<AsAsked> made_as_asked(const SearchRequest& request, EvaluationBudget& budget, Launch at, double turn) {
  const Goal goal = Goal::of(request, Demand::made);
  const auto follow = [&] { return replay(request, budget, {at.speed, wrap_angle(at.angle)}, goal); };
  Replay r = follow();
  double slope = square(r.path.arrival.speed / at.speed);
  for (int n = 0; n < settings::most_steps && r.made && !as_fast(request, r.path.arrival.speed) && slope > 0; ++n) {
    if (budget.spent()) return {};
    const double before = square(at.speed), arrived = square(r.path.arrival.speed);
    const double off = square(wanted(request, r.path.arrival.speed)) - arrived;
    const double faster = std::sqrt(1 + std::clamp(off / (slope * before), -0.5, 1.0));
    at.speed *= faster;
    at.angle += turn * std::log(faster);
    r = follow();
    const double grown = (square(r.path.arrival.speed) - arrived) / (square(at.speed) - before);
    if (grown > 0) slope = grown;
  }
  if (!r.made || !as_fast(request, r.path.arrival.speed) || budget.spent()) return {};
  return AsAsked{{at.speed, wrap_angle(at.angle)}, r};
}

}  // namespace bankshot::planning
