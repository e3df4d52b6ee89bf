// SPDX-License-Identifier: MIT
#include "planners/learn/models.hpp"

namespace bankshot::planning {
namespace {

/// A slope of exactly 0 would be none.
Restitution bounce_of(Restitution e, FitWish::Bounce bounce) {
  constexpr double slope = 1e-4;
  if (bounce == FitWish::Bounce::as_given) return e;
  if (bounce == FitWish::Bounce::constant) return {e(1.0)};
  if (e.per_speed == 0) e.per_speed = -slope;
  if (bounce == FitWish::Bounce::linear) return {e.at_rest, e.per_speed};
  if (e.per_speed2 == 0) e.per_speed2 = -slope;
  return e;
}

}  // namespace

Physics with_model(Physics p, const std::string& model, FitWish::Bounce bounce, const Body& body) {
  if (!carries_spin(p)) return p;
  const Restitution e = bounce_of(restitution(p), bounce);
  const Han2005 usual = std::get<Han2005>(spin_physics(body).cushion);
  double height = usual.height, friction = usual.friction;
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.height; }) height = c.height, friction = c.friction;
        if constexpr (requires { c.restitution; }) c.restitution = e;
      },
      p.cushion);
  if (model == "mirror") p.cushion = Mirror{e};
  if (model == "han2005") p.cushion = Han2005{height, e, friction};
  if (model == "stronge") p.cushion = Stronge{height, e, friction};
  if (model == "mathavan2010")
    p.cushion = Mathavan2010{.height = height,
                             .restitution = e,
                             .friction = friction,
                             .sliding_friction = std::get<SlideRoll>(p.motion).sliding_friction};
  return p;
}

std::string model_name(const Physics& p) {
  constexpr const char* names[] = {"mirror", "han2005", "mathavan2010", "stronge", "custom"};
  const Restitution& e = restitution(p);
  return std::string(names[p.cushion.index()]) + (e.constant()        ? ""
                                                  : e.per_speed2 != 0 ? ", restitution by speed squared"
                                                                      : ", restitution by speed");
}

}  // namespace bankshot::planning
