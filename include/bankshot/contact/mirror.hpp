// SPDX-License-Identifier: MIT
//
// The simplest cushion: the normal velocity is reversed and multiplied by the restitution, the
// tangential velocity is kept. Restitution 1 is the law of mirrors.
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

struct Mirror {
  double restitution = 0.85;  ///< e in [0, 1]

  /// `normal` is a unit vector that points away from the cushion, into the table.
  template <class T, class N>
  void bounce(State<T>& s, const Vec2<N>& normal) const {
    const Vec2<T> n = to<T>(normal);
    s.velocity -= n * (T(1 + restitution) * dot(n, s.velocity));
  }
};

}  // namespace bankshot
