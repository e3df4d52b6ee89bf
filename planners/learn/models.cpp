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
  const Han2005 usual = std::get<Han2005>(spin_physics(body).cushion);
  double height = usual.height, friction = usual.friction;
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.height; }) height = c.height, friction = c.friction;
        if constexpr (requires { c.restitution; }) c.restitution = e;
      },
      p.cushion);
  if (wish.model == "mirror") p.cushion = Mirror{e};
  if (wish.model == "han2005") p.cushion = Han2005{height, e, friction};
  if (wish.model == "stronge") p.cushion = Stronge{height, e, friction};
  if (wish.model == "mathavan2010")
    p.cushion = Mathavan2010{
        .height = height, .restitution = e, .friction = friction, .sliding_friction = cloth.sliding_friction};
  if (auto* law = std::get_if<Mathavan2010>(&p.cushion))
    law->tolerance = std::max(law->tolerance, settings::learn::impact);
  return p;
}

void restore_tolerance(Physics& p) {
  if (auto* law = std::get_if<Mathavan2010>(&p.cushion)) law->tolerance = tolerance::impact;
}

std::string model_name(const Physics& p) {
  constexpr const char* names[] = {"mirror", "han2005", "mathavan2010", "stronge", "custom"};
  const Restitution& e = restitution(p);
  return std::string(names[p.cushion.index()]) + (e.constant()        ? ""
                                                  : e.per_speed2 != 0 ? ", restitution by speed squared"
                                                                      : ", restitution by speed");
}

}  // namespace bankshot::planning
