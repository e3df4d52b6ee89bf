// SPDX-License-Identifier: MIT
//
// The locked sequence: a path that is *told* which cushions it meets, on their infinite lines.
// Where the real path jumps from one cushion to another at a corner, the locked one stays smooth,
// which is what a root finder with derivatives needs. Two aims just either side of a corner have
// locked paths that differ by little; a bounce may lie at slightly negative time when the ball is
// already past the line. Pockets are not seen: the real simulator decides afterwards.
#pragma once

#include <span>

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/boundary.hpp"
#include "bankshot/simulate/roots.hpp"

namespace bankshot {

/// How a locked path ended: at the end of its sequence, stopped while moving towards the next
/// cushion (more speed would help), or moving away from it (another aim would).
enum class LockedEnd { complete, fell_short, wrong_way };

template <class T>
struct LockedPath {
  State<T> state;  ///< right after the last bounce
  T time;          ///< s since the launch
  LockedEnd end = LockedEnd::complete;
};

/// Time to the line of wall w, negative when the centre is already beyond it.
template <class T>
T time_to_line(const Arc<T>& arc, const Wall& w) {
  using std::sqrt;
  const T gap = dot(w.normal, arc.at) - T(w.offset), speed = dot(w.normal, arc.velocity);
  const T discriminant = speed * speed - T(2) * dot(w.normal, arc.acceleration) * gap;
  if (discriminant < T(0)) return T(forever);
  return T(2) * gap / (sqrt(discriminant) - speed);
}

template <class T, class Motion, class Cushion>
LockedPath<T> follow_locked(const Boundary& boundary, const Motion& motion, const Cushion& cushion,
                            std::span<const int> contacts, const State<T>& start) {
  LockedPath<T> path{start, T(0)};
  for (const int contact : contacts) {
    const Arc<T> arc = motion.arc(path.state);
    const auto i = static_cast<std::size_t>(contact);
    T t(0);
    Vec2<T> normal;
    if (i < boundary.walls.size()) {
      const Wall& w = boundary.walls[i];
      normal = to<T>(w.normal);
      if (!(dot(normal, arc.velocity) < T(0))) return path.end = LockedEnd::wrong_way, path;
      t = time_to_line(arc, w);
    } else {
      for (const Circle& c : boundary.tips)
        if (c.contact == contact) t = first_entry(arc, c.centre, c.radius);
      if (!(t < T(forever))) return path.end = LockedEnd::wrong_way, path;
    }
    if (!(t <= arc.duration)) return path.end = LockedEnd::fell_short, path;
    path.time += t;
    path.state = arc.state_at(t);
    for (const Circle& c : boundary.tips)
      if (c.contact == contact) normal = (path.state.at - to<T>(c.centre)) / T(c.radius);
    cushion.bounce(path.state, normal);
  }
  return path;
}

}  // namespace bankshot
