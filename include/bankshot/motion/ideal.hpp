// SPDX-License-Identifier: MIT
//
// Constant speed on a straight line, as in mathematical billiards: the equations of `Ideal` (scene/laws.hpp).
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/laws.hpp"

namespace bankshot {

template <class T>
inline Arc<T> Ideal::arc(const Body&, const State<T>& s) const {
  const bool moves = value(s.velocity.x) != 0 || value(s.velocity.y) != 0;
  return {s.at, s.velocity, {T(0), T(0)}, T(moves ? forever : 0), moves ? PhaseEnd::none : PhaseEnd::rest};
}

template <class T>
inline Vec3<T> Ideal::spin(const Body& body, const State<T>& s) const {
  return natural_roll(s.velocity, body.radius);
}

}  // namespace bankshot
