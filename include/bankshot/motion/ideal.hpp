// SPDX-License-Identifier: MIT
//
// Constant speed on a straight line, as in mathematical billiards.
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

struct Ideal {
  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const Body&, const State<T>& s) const {
    const bool moves = value(s.velocity.x) != 0 || value(s.velocity.y) != 0;
    return {s.at, s.velocity, {T(0), T(0)}, T(moves ? forever : 0), moves ? PhaseEnd::none : PhaseEnd::rest};
  }
  template <class T>
  void turn(const Body&, State<T>&, const Arc<T>&, const T&) const {}
  template <class T>
  void finish(const Body&, State<T>&, const Arc<T>&) const {}
  template <class T>
  void roll(const Body&, State<T>&) const {}
  template <class T>
  Vec3<T> spin(const Body& body, const State<T>& s) const {
    return natural_roll(s.velocity, body.radius);
  }
  /// Returns the deceleration along the path [m/s²].
  double deceleration() const { return 0; }
};

}  // namespace bankshot
