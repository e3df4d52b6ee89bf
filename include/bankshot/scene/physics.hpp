// SPDX-License-Identifier: MIT
//
// Which laws a scene follows. The scene decides once; `with_physics` then runs a generic function
// with the concrete types, so that the simulator pays for nothing it does not model.
#pragma once

#include <utility>
#include <variant>

#include "bankshot/contact/mirror.hpp"
#include "bankshot/motion/ideal.hpp"
#include "bankshot/motion/rolling.hpp"

namespace bankshot {

struct Physics {
  std::variant<Ideal, Rolling> motion = Rolling{};
  Mirror cushion{};
};

inline Physics ideal_physics() { return {Ideal{}, Mirror{.restitution = 1}}; }
inline Physics rolling_physics() { return {Rolling{}, Mirror{}}; }

/// `f(motion, cushion)` with the types the scene holds.
template <class F>
decltype(auto) with_physics(const Physics& p, F&& f) {
  return std::visit([&](const auto& motion) -> decltype(auto) { return f(motion, p.cushion); },
                    p.motion);
}

inline bool is_ideal(const Physics& p) { return std::holds_alternative<Ideal>(p.motion); }

/// Deceleration along the path [m/s²].
inline double deceleration(const Physics& p) {
  return std::visit([](const auto& m) { return m.deceleration(); }, p.motion);
}

}  // namespace bankshot
