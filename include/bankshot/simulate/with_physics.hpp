// SPDX-License-Identifier: MIT
//
// From the data of a scene's laws to their concrete types, so that the simulator does not pay for effects that it does
// not model. This header includes the equations of all laws.
#pragma once

#include <type_traits>
#include <variant>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/motion/ideal.hpp"
#include "bankshot/motion/rolling.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/motion/tilted.hpp"
#include "bankshot/scene/physics.hpp"

namespace bankshot {

/// Returns the law of motion for a table that is not level.
Tilted tilted(const Physics& physics);

/// Calls `f(motion)` with the concrete type of the motion.
template <class F>
decltype(auto) with_motion(const Physics& p, F&& f) {
  if (!is_level(p)) return f(tilted(p));
  return std::visit([&](const auto& motion) -> decltype(auto) { return f(motion); }, p.motion);
}

/// Calls `f(motion, cushion)` with the concrete type of the motion. Cushions that act on spin require a motion that
/// carries spin; with other motions every cushion is a mirror. The default law of spinning balls is passed as it is,
/// every other law as `AnyCushion`: each further type would compile all callers once more.
template <class F>
decltype(auto) with_physics(const Physics& p, F&& f) {
  if (!is_level(p)) return f(tilted(p), AnyCushion{p.cushion});
  return std::visit(
      [&](const auto& motion) -> decltype(auto) {
        if constexpr (std::decay_t<decltype(motion)>::straight) {
          return f(motion, std::get<Mirror>(p.cushion));
        } else {
          if (const auto* usual = std::get_if<UsualCushion>(&p.cushion)) return f(motion, *usual);
          return f(motion, AnyCushion{p.cushion});
        }
      },
      p.motion);
}

}  // namespace bankshot
