// SPDX-License-Identifier: MIT
//
// The slide of a ball that a cushion holds. The cushion takes the part of the friction that drives the ball into it,
// but friction still turns the ball as a whole. With û = û_t t + û_n n, where n points across the cushion,
//   v̇ = −μs g û_t t,  u̇ = v̇ − (5/2) μs g û = −μs g (7/2 û_t t + 5/2 û_n n)
// The slip turns across the cushion while it fades, and the path has no closed form.
// Method: pieces with constant û, as it will be in the middle of the piece. Each lasts 2 ms at most, and half as long
// as the slip would last in its first direction. Error of a piece of h seconds, for a slip that lasts T: (h/T)² of the
// speed that it takes away. The time and place of its end are therefore right to 0.03 %. The slip that is left in its
// last microsecond, 5 µm/s at most, is dropped.
// Worked number: a ball that slips at 1 m/s straight into its cushion, μs = 0.2, rolls after 1/(5/2 · 1.962) = 0.204 s.
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::detail {

/// Turns a sliding ball's arc into a piece along the cushion. Its speed across the cushion must be 0 already, and its
/// acceleration the whole friction. If the arc is a piece already, friction keeps its direction. `n` points across the
/// cushion.
template <class T>
void hold_slip(Arc<T>& arc, const Vec2<Real<T>>& n) {
  using std::sqrt;
  using N = Real<T>;
  const auto across = [&](const Vec2<T>& a) {
    const T part = dot(n, a);
    return Vec2<T>{part * n.x, part * n.y};
  };
  Vec2<T> friction = arc.acceleration;
  if (arc.end == PhaseEnd::roll) {
    const Vec2<T> free = friction - across(friction);
    const T size2 = dot(friction, friction), alone = arc.duration;
    arc.duration = alone * N(3.5) / T(dot(free, free) / size2 + N(2.5));
    if (value(arc.duration) > N(tolerance::last_piece)) {
      arc.end = PhaseEnd::piece;
      arc.duration = arc.duration * N(0.5);
      if (value(arc.duration) > N(tolerance::longest_piece)) arc.duration = T(N(tolerance::longest_piece));
      const T middle = arc.duration / T(alone * N(7));
      const Vec2<T> later = friction * T(T(1) - middle * N(2.5)) - free * middle;
      friction = later * T(sqrt(T(size2 / dot(later, later))));
    }
  }
  arc.taken = across(friction);
  arc.acceleration = friction - arc.taken;
}

/// Holds a sliding ball between two cushions, where it stays in its place. The slip keeps its direction.
template <class T>
void hold_slip_in_corner(Arc<T>& arc) {
  arc.taken = arc.acceleration;
  arc.velocity = arc.acceleration = {T(0), T(0)};
  if (arc.end == PhaseEnd::roll) arc.duration = arc.duration * Real<T>(1.4);
}

}  // namespace bankshot::detail
