// SPDX-License-Identifier: MIT
#include "planners/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// Returns the launch half way between two. It takes back half of a step that led nowhere, also from where no path
/// arrives.
Launch half_way(const Launch& a, const Launch& b) { return {std::sqrt(a.speed * b.speed), (a.angle + b.angle) / 2}; }

/// Returns whether a launch lies farther from the start than a search may go.
bool left(const Launch& from, const Launch& at, const Neighbourhood& near) {
  return std::abs(at.angle - from.angle) > near.far * near.step_aim ||
         std::abs(std::log(at.speed / from.speed)) > near.far * near.step_speed;
}

}  // namespace

std::optional<Step> newton_step(const Linear& l, bool one_unknown) {
  const double det = l.determinant(one_unknown);
  if (det == 0) return {};
  if (one_unknown) return Step{-l.r[0] / det, 0};
  return Step{(l.by_speed(0) * l.r[1] - l.by_speed(1) * l.r[0]) / det,
              (l.by_aim(1) * l.r[0] - l.by_aim(0) * l.r[1]) / det};
}

double size_of(const Step& step, const Neighbourhood& near) {
  const double aim = std::abs(step[0]) / near.step_aim, speed = std::abs(step[1]) / near.step_speed;
  return std::isfinite(aim) && std::isfinite(speed) ? std::max(aim, speed) : std::numeric_limits<double>::infinity();
}

std::optional<Launch> newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Neighbourhood& near,
                             const Known& known) {
  using namespace settings::newton;
  Launch at = from, before = from;
  bool rough = impact_tolerance(aim.request.problem->rough.cushion);  // until the root is near
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < settings::most_steps; ++i) {
    auto l = linearise(aim, budget, at, rough);
    const auto worse = [&] { return !l || (i >= settings::patience && !(l->size() < least)); };
    if (i > 0 && worse()) {
      at = half_way(at, before);
      l = linearise(aim, budget, at, rough);
    }
    if (i >= settings::patience && worse()) return {};
    before = at;
    if (l) least = std::min(least, l->size());
    const auto step = l ? newton_step(*l, aim.request.one_unknown()) : std::nullopt;
    if (!step) return {};
    const double size = size_of(*step, near);
    if (!std::isfinite(size)) return {};
    const double damped = size > 1 ? 1 / size : 1;
    at.angle += damped * (*step)[0];
    at.speed *= std::exp(damped * (*step)[1]);
    if (known && known(at, size, *l)) return {};
    const bool exact = !std::exchange(rough, rough && size > fine_from);
    if (exact && size < settings::settled) return Launch{at.speed, wrap_angle(at.angle)};
    if (left(from, at, near)) return {};
  }
  return {};
}

}  // namespace bankshot::planning
