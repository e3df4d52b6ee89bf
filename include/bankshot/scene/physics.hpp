// SPDX-License-Identifier: MIT
//
// Which laws a scene follows. The scene decides once; `with_physics` then runs a generic function
// with the concrete types, so that the simulator pays for nothing it does not model.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/motion/ideal.hpp"
#include "bankshot/motion/rolling.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/motion/tilted.hpp"

namespace bankshot {

/// How well coefficients are known that were fitted (learn/fit.hpp).
struct CoefficientErrors {
  std::vector<std::string> names{};
  std::vector<double> covariance{};  ///< row by row, in the units of each
};

struct Physics {
  std::variant<Ideal, Rolling, SlideRoll> motion = Rolling{};
  CushionVariant cushion = Mirror{};
  BallBall ball_ball{};
  Vec2d tilt{};                               ///< rise of the cloth per metre, along x and y; 0 in `ideal`
  std::optional<CoefficientErrors> errors{};  ///< none: the coefficients are exact
};

/// How balls of this physics collide: elastically in `ideal`, without friction where no spin is carried.
BallBall collisions(const Physics& physics);

inline Physics ideal_physics() { return {Ideal{}, Mirror{.restitution = 1}}; }
inline Physics rolling_physics() { return {Rolling{}, Mirror{}}; }
/// The default: sliding, rolling and spin on cloth, cushions after Han 2005. The spinning friction is that of a ball of
/// this size, and so is the height of the cushions' nose [m], 1.28 R, unless it is given.
Physics spin_physics(const Body& body = {}, std::optional<double> nose_height = {});

/// m/s²; 0 in `ideal`, which knows no weight.
double gravity(const Physics& p);

inline bool is_level(const Physics& p) { return p.tilt == Vec2d{}; }
/// The motion on a table that is not level.
Tilted tilted(const Physics& physics);

/// `f(motion)` with the type the scene has.
template <class F>
decltype(auto) with_motion(const Physics& p, F&& f) {
  if (!is_level(p)) return f(tilted(p));
  return std::visit([&](const auto& motion) -> decltype(auto) { return f(motion); }, p.motion);
}

/// `f(motion, cushion)` with the types the scene holds. Cushions that act on spin exist only where
/// the motion carries it; elsewhere every cushion is a mirror.
template <class F>
decltype(auto) with_physics(const Physics& p, F&& f) {
  if (!is_level(p)) return f(tilted(p), AnyCushion{p.cushion});
  return std::visit(
      [&](const auto& motion) -> decltype(auto) {
        if constexpr (std::decay_t<decltype(motion)>::straight)
          return f(motion, std::get<Mirror>(p.cushion));
        else
          return std::visit([&](const auto& cushion) -> decltype(auto) { return f(motion, cushion); }, p.cushion);
      },
      p.motion);
}

inline bool is_ideal(const Physics& p) { return std::holds_alternative<Ideal>(p.motion); }

/// A ball slides, and keeps spin.
inline bool carries_spin(const Physics& p) { return std::holds_alternative<SlideRoll>(p.motion); }

/// The shape of a path does not depend on its speed: aims have a closed form.
inline bool is_straight(const Physics& p) { return !carries_spin(p) && is_level(p); }

/// A ball that stands stays where it is.
bool rests(const Physics& p);

/// Deceleration of a slow ball that rolls on a level table [m/s²].
inline double deceleration(const Physics& p) {
  return std::visit([](const auto& m) { return m.deceleration(); }, p.motion);
}

/// The same on this table, whichever way the ball rolls: not below 0.
double least_deceleration(const Physics& p);

inline const Restitution& restitution(const Physics& p) {
  return std::visit([](const auto& c) -> const Restitution& { return c.restitution; }, p.cushion);
}

}  // namespace bankshot
