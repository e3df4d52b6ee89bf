// SPDX-License-Identifier: MIT
//
// The laws that a scene follows, as data. They are chosen once per scene; `with_physics` (simulate/with_physics.hpp)
// then calls a generic function with the concrete motion, and with the concrete cushion where it is the usual one.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/scene/laws.hpp"

namespace bankshot {

/// The uncertainty of fitted coefficients (learn/fit.hpp).
struct CoefficientErrors {
  std::vector<std::string> names{};
  std::vector<double> covariance{};  ///< row by row, in the units of the coefficients
};

struct Physics {
  std::variant<Ideal, Rolling, SlideRoll> motion = Rolling{};
  CushionVariant cushion = Mirror{};
  BallBall ball_ball{};
  Vec2d tilt{};                               ///< rise of the cloth per metre, along x and y; 0 in `ideal`
  std::optional<CoefficientErrors> errors{};  ///< none: the coefficients are exact
};

/// Returns the law of ball collisions: elastic in `ideal` physics, and without friction if balls carry no spin.
BallBall collisions(const Physics& physics);

inline Physics ideal_physics() { return {Ideal{}, Mirror{.restitution = 1}}; }
inline Physics rolling_physics() { return {Rolling{}, Mirror{}}; }
/// Returns the default physics: sliding, rolling and spin on cloth, and the usual cushions. The spinning friction is
/// scaled to the ball's radius R, and so is the nose height [m], 1.28 R, unless it is given.
Physics spin_physics(const Body& body = {}, std::optional<double> nose_height = {});

/// Returns the gravitational acceleration [m/s²]; 0 in `ideal` physics, which has no weight.
double gravity(const Physics& p);

inline bool is_level(const Physics& p) { return p.tilt == Vec2d{}; }
inline bool is_ideal(const Physics& p) { return std::holds_alternative<Ideal>(p.motion); }

/// Returns true if balls can slide and have spin.
inline bool carries_spin(const Physics& p) { return std::holds_alternative<SlideRoll>(p.motion); }

/// Returns true if the shape of a path does not depend on its speed. Aims then have a closed form.
inline bool is_straight(const Physics& p) { return !carries_spin(p) && is_level(p); }

/// Returns true if a ball at rest stays at rest.
bool rests(const Physics& p);

/// Returns the deceleration of a slow ball that rolls on a level table [m/s²].
inline double deceleration(const Physics& p) {
  return std::visit([](const auto& m) { return m.deceleration(); }, p.motion);
}

/// Returns the least deceleration on this table over all directions of rolling [m/s²]; at least 0.
double least_deceleration(const Physics& p);

inline const Restitution& restitution(const Physics& p) {
  return std::visit([](const auto& c) -> const Restitution& { return c.restitution; }, p.cushion);
}

}  // namespace bankshot
