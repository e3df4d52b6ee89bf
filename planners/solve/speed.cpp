// SPDX-License-Identifier: MIT
#include "planners/solve/speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/settings.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning {
namespace {

/// Returns the step of ln speed to the root of the residual of speed. To stop, it leads to the point on the line of
/// rests nearest to the aim point, which is a minimum and no change of sign.
double step_of_speed(const Linear& l, bool stop) {
  if (!stop) return -l.r[1] / l.by_speed(1);
  return -(l.r[0] * l.by_speed(0) + l.r[1] * l.by_speed(1)) /
         (l.by_speed(0) * l.by_speed(0) + l.by_speed(1) * l.by_speed(1));
}

}  // namespace

std::optional<double> speed_near(const Branch& aim, EvaluationBudget& budget, double angle, double guess) {
  if (aim.request.one_unknown()) return guess;
  constexpr double longest_step = settings::wide.step_speed;
  double speed = guess, low = 0, high = infinite;
  for (int i = 0; i < settings::most_steps; ++i) {
    const auto l = linearise(aim, budget, {speed, angle});
    double next = 0;
    if (l) {
      const double step = step_of_speed(*l, aim.request.stop);
      if (std::abs(step) < settings::settled * longest_step) return speed * std::exp(step);
      if (!aim.request.stop) (l->r[1] > 0 ? high : low) = speed;
      next = speed * std::exp(std::clamp(step, -longest_step, longest_step));
    } else {
      low = speed;  // it does not get there
    }
    if (!(next > low && next < high))
      next = !(low > 0)        ? high * std::exp(-longest_step)
             : high < infinite ? std::sqrt(low * high)
                               : low * std::exp(longest_step);
    if (high - low < settings::rounding * high) return speed;
    speed = next;
  }
  return {};
}

std::optional<double> speed_at(const Branch& aim, EvaluationBudget& budget, double angle, double length) {
  const SearchRequest& request = aim.request;
  if (request.one_unknown()) return request.fixed_speed();
  using namespace settings::speed_at;
  const double asked = even_square(request.puzzle().physics, request.asked * request.asked),
               slowing = 2 * deceleration(request.puzzle().physics);
  const auto excess = [&](double square) { return excess_speed2(aim, budget, angle, square); };
  const Range& bounds = request.speed;
  const double slowest = std::max(bounds.low, settings::slowest_of_fastest * bounds.high);
  double low = slowest * slowest, high = bounds.high * bounds.high;
  const auto most = excess(high);
  if (!most || *most < 0) return {};
  // The excess is nearly linear in the square of the launch speed: bounces take a share of that, rolling the same from
  // all.
  double at = high, over = *most, slope = (over + asked + slowing * length) / high;
  while (high - low > near * high) {
    const double next = at - over / slope;
    const bool inside = next > low && next < high;
    if (inside && std::abs(next - at) < near * next) return std::sqrt(next);
    const double tried = inside ? next : std::sqrt(low * high);
    const auto e = excess(tried);
    (e && *e >= 0 ? high : low) = tried;
    if (!e) continue;
    if ((*e - over) / (tried - at) > 0) slope = (*e - over) / (tried - at);
    at = tried;
    over = *e;
  }
  return std::sqrt(high);
}

}  // namespace bankshot::planning
