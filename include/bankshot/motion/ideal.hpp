// SPDX-License-Identifier: MIT
//
// Constant speed on a straight line: the billiard of mathematics.
#pragma once

#include "bankshot/motion/arc.hpp"

namespace bankshot {

struct Ideal {
  static constexpr PhaseEnd phase_end = PhaseEnd::none;
  /// The path does not depend on the speed, only how far the ball gets.
  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const State<T>& s) const {
    return {s.at, s.velocity, {T(0), T(0)}, T(forever)};
  }
  /// Deceleration along the path [m/s²].
  double deceleration() const { return 0; }
};

}  // namespace bankshot
