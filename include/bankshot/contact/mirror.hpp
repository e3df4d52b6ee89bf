// SPDX-License-Identifier: MIT
//
// The simplest cushion. It reverses the normal velocity, multiplied by the restitution, and keeps the tangential
// velocity and the spin. Restitution 1 is the law of mirrors.
#pragma once

#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

template <class C>
template <class T, class N>
inline void MirrorOf<C>::bounce(const Body&, State<T>& s, const Vec2<N>& away) const {
  const T impulse = restitution.rebound(T(-dot(away, s.velocity)));
  s.velocity.x += impulse * away.x;
  s.velocity.y += impulse * away.y;
}

}  // namespace bankshot
