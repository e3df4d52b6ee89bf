// SPDX-License-Identifier: MIT
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/with_physics.hpp"

#include <algorithm>

namespace bankshot {

Physics spin_physics(const Body& body, std::optional<double> nose_height) {
  return {SlideRoll{.spinning_friction = 4.0 / 9 * body.radius},
          UsualCushion{.height = nose_height.value_or(1.28 * body.radius)}};
}

double gravity(const Physics& p) {
  if (const auto* const spins = std::get_if<SlideRoll>(&p.motion)) return spins->g;
  const auto* const rolls = std::get_if<Rolling>(&p.motion);
  return rolls ? rolls->g : 0;
}

Tilted tilted(const Physics& physics) {
  Tilted out;
  out.rise = physics.tilt;
  if (const auto* const spins = std::get_if<SlideRoll>(&physics.motion)) {
    static_cast<SlideRoll&>(out) = *spins;
  } else if (const auto* const rolls = std::get_if<Rolling>(&physics.motion)) {
    out.always_rolls = true;
    out.rolling_friction = rolls->friction;
    out.g = rolls->g;
  }
  return out;
}

double least_deceleration(const Physics& p) {
  return std::max(0.0, deceleration(p) - gravity(p) * norm(p.tilt) * 5 / 7);
}

bool rests(const Physics& p) { return !(gravity(p) * norm(p.tilt) * 5 / 7 > deceleration(p)); }

BallBall collisions(const Physics& physics) {
  if (is_ideal(physics)) return {.restitution = 1, .friction = 0, .lasts = false};
  BallBall law = physics.ball_ball;
  if (!carries_spin(physics)) law.friction = 0;
  return law;
}

}  // namespace bankshot
