// SPDX-License-Identifier: MIT
//
// The simplest cushion. It reverses the normal velocity, multiplied by the restitution, and keeps the tangential
// velocity and the spin. Restitution 1 is the law of mirrors.
#pragma once

#include "bankshot/contact/restitution.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

template <class C>
struct MirrorOf {
  RestitutionOf<C> restitution{};

  /// `normal` is a unit vector that points away from the cushion, into the table.
  template <class T, class N>
  void bounce(const Body&, State<T>& s, const Vec2<N>& normal) const {
    const T impulse = restitution.rebound(T(-dot(normal, s.velocity)));
    s.velocity.x += impulse * normal.x;
    s.velocity.y += impulse * normal.y;
  }
};
using Mirror = MirrorOf<double>;

}  // namespace bankshot
