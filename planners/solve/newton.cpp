// SPDX-License-Identifier: MIT
#include "planners/solve/newton.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// Returns the launch half way between two. It takes back half of a step that led nowhere, also from where no path
/// arrives.
Launch half_way(const Launch& a, const Launch& b) { return {std::sqrt(a.speed * b.speed), (a.angle + b.angle) / 2}; }

/// Returns the size of a step in longest steps; infinite where a component is not finite.
double size_of(const Step& step, const Unknowns& unknowns) {
  double size = 0;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double part = std::abs(step[k]) / unknowns[k].longest_step;
    size = std::isfinite(part) ? std::max(size, part) : std::numeric_limits<double>::infinity();
  }
  return size;
}

bool left(const Launch& from, const Launch& at, const Unknowns& unknowns) {
  return std::any_of(unknowns.begin(), unknowns.end(),
                     [&](const Unknown& u) { return std::abs(difference(from, at, u.what)) > u.farthest; });
}

}  // namespace

std::optional<Step> newton_step(const Linear& l, bool one_unknown) {
  const double det = l.determinant(one_unknown);
  if (det == 0) return {};
  if (one_unknown) return Step{-l.r[0] / det, 0};
  return Step{(l.by_speed(0) * l.r[1] - l.by_speed(1) * l.r[0]) / det,
              (l.by_aim(1) * l.r[0] - l.by_aim(0) * l.r[1]) / det};
}

NewtonResult newton(const Branch& aim, EvaluationBudget& budget, const Launch& from, const Unknowns& unknowns,
                    const Known& known) {
  using namespace settings::newton;
  NewtonResult result{from};
  Launch& at = result.launch;
  Launch before = from;
  bool rough = impact_tolerance(aim.request.problem->rough.cushion);  // until the root is near
  double least = std::numeric_limits<double>::infinity();
  const auto end = [&](NewtonStatus status) { return result.status = status, result; };
  for (int& i = result.iterations; i < settings::most_steps; ++i) {
    auto l = linearise(aim, budget, at, rough);
    const auto worse = [&] { return !l || (i >= settings::patience && !(l->size() < least)); };
    if (i > 0 && worse()) {
      at = half_way(at, before);
      l = linearise(aim, budget, at, rough);
    }
    if (i >= settings::patience && worse()) return end(NewtonStatus::astray);
    before = at;
    if (l) least = std::min(least, l->size());
    const auto step = l ? newton_step(*l, unknowns.size() == 1) : std::nullopt;
    if (!step) return end(NewtonStatus::singular);
    const double size = size_of(*step, unknowns);
    if (!std::isfinite(size)) return end(NewtonStatus::singular);
    const double damped = size > 1 ? 1 / size : 1;
    for (std::size_t k = 0; k < unknowns.size(); ++k) move(at, unknowns[k].what, damped * (*step)[k]);
    if (known && known(at, size, *l)) return end(NewtonStatus::known);
    const bool exact = !std::exchange(rough, rough && size > fine_from);
    if (exact && size < settings::settled) return at.angle = wrap_angle(at.angle), end(NewtonStatus::converged);
    if (left(from, at, unknowns)) return end(NewtonStatus::left);
  }
  return end(NewtonStatus::astray);
}

}  // namespace bankshot::planning
