// SPDX-License-Identifier: MIT
#include "planners/learn/models.hpp"

#include <algorithm>

#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

using BySpeed = FitWish::BySpeed;

/// Starting value of a slope in the speed; a slope of exactly 0 would count as none.
constexpr double slope = 1e-4;

Restitution by_speed(Restitution e, BySpeed wish) {
  if (wish == BySpeed::as_given) return e;
  if (wish == BySpeed::constant) return {e(1.0)};
  if (e.per_speed == 0) e.per_speed = -slope;
  if (wish == BySpeed::linear) return {e.at_rest, e.per_speed};
  if (e.per_speed2 == 0) e.per_speed2 = -slope;
  return e;
}

RollingFriction by_speed(RollingFriction f, BySpeed wish) {
  if (wish == BySpeed::constant) return {f.at_rest};
  if (wish != BySpeed::as_given && f.per_speed == 0) f.per_speed = slope;
  return f;
}

}  // namespace

Physics with_laws(Physics p, const FitWish& wish, const Body& body) {
  if (!carries_spin(p)) return p;
  SlideRoll& cloth = std::get<SlideRoll>(p.motion);
  cloth.rolling_friction = by_speed(cloth.rolling_friction, wish.rolling);
  const Restitution e = by_speed(restitution(p), wish.restitution);
  std::visit([&](auto& law) { law.restitution = e; }, p.cushion);
  if (const auto model = find_cushion_model(wish.model)) {
    CushionVariant start = spin_physics(body).cushion;
    take_coefficients(start, p.cushion);
    p.cushion = default_cushion(*model);
    take_coefficients(p.cushion, start);
    if (double* const of_cloth = cloth_friction(p.cushion)) *of_cloth = cloth.sliding_friction;
  }
  if (double* const error = impact_tolerance(p.cushion)) *error = std::max(*error, settings::learn::impact);
  return p;
}

void restore_tolerance(Physics& p) {
  if (double* const error = impact_tolerance(p.cushion)) *error = tolerance::impact;
}

std::string model_name(const Physics& p) {
  const Restitution& e = restitution(p);
  return std::string(model_of(p.cushion).key) + (e.constant()        ? ""
                                                 : e.per_speed2 != 0 ? ", restitution by speed squared"
                                                                     : ", restitution by speed");
}

}  // namespace bankshot::planning
