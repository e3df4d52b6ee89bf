// SPDX-License-Identifier: MIT
#include "bankshot/scene/physics.hpp"

namespace bankshot {

Physics spin_physics(const Body& body, std::optional<double> nose_height) {
  return {SlideRoll{.spinning_friction = 4.0 / 9 * body.radius},
          Han2005{.height = nose_height.value_or(1.28 * body.radius)}};
}

BallBall collisions(const Physics& physics) {
  if (is_ideal(physics)) return {.restitution = 1, .friction = 0, .lasts = false};
  BallBall law = physics.ball_ball;
  if (is_straight(physics)) law.friction = 0;
  return law;
}

}  // namespace bankshot
