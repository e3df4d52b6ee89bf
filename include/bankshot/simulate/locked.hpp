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

/// Time to the line of wall w, negative when the centre is already beyond it and moving on.
template <class T>
T time_to_line(const Arc<T>& arc, const Wall& w) {
  using std::sqrt;
  using Number = Real<T>;
  const Number speed = dot(w.normal, value(arc.velocity)), a = dot(w.normal, value(arc.acceleration));
  const Number gap = dot(w.normal, value(arc.at)) - Number(w.offset);
  Number t;
  if (!(speed < Number(0))) {
    t = first_descent(gap > Number(0) ? gap : Number(0), speed, a);
  } else {
    // Without acceleration no square, which would underflow for the slowest approach.
    const Number discriminant = speed * speed - 2 * a * gap;
    if (discriminant < Number(0)) return T(forever);
    t = a == Number(0) ? Number(gap / -speed) : Number(2 * gap / (sqrt(discriminant) - speed));
  }
  if (!(t < Number(forever))) return T(forever);
  return lift_line(arc, w.normal, w.offset, !(speed < Number(0)) && !(gap > Number(0)), t);
}

template <class T>
T time_to_contact(const Boundary& boundary, const Arc<T>& arc, int contact) {
  if (boundary.is_wall(contact)) return time_to_line(arc, boundary.wall(contact));
  const Circle* const tip = boundary.tip(contact);
  if (!tip) return T(forever);
  const Real<T> t = first_entry(value(arc), tip->centre, tip->radius, value(arc.duration));
  return t < Real<T>(forever) ? lift_circle(arc, tip->centre, t) : T(forever);
}

template <class T, class Motion, class Cushion>
LockedPath<T> follow_locked(const Boundary& boundary, const Motion& motion, const Cushion& cushion,
                            std::span<const int> contacts, const State<T>& start) {
  LockedPath<T> path{start, T(0)};
  for (const int contact : contacts) {
    for (;;) {
      const Arc<T> arc = motion.arc(path.state);
      const T t = time_to_contact(boundary, arc, contact);
      const bool met = t <= arc.duration && t < T(forever);
      if (!met && arc.end != PhaseEnd::roll) {
        const bool towards = dot(boundary.normal(contact, value(arc.at)), value(arc.velocity)) < Real<T>(0);
        path.end = towards ? LockedEnd::fell_short : LockedEnd::wrong_way;
        return path;
      }
      const T on = met ? t : arc.duration;
      path.time += arc.seconds(on);
      path.state = advance(motion, path.state, arc, on);
      if (met) break;
      motion.finish(path.state, arc);
    }
    if (boundary.is_wall(contact))
      cushion.bounce(path.state, boundary.wall(contact).normal);
    else
      cushion.bounce(path.state, boundary.normal(contact, path.state.at));
  }
  return path;
}

/// The last leg of a locked path: the state where the ball is abreast of the target, or enters the
/// circle of radius `capture` around it, or comes to rest.
template <class T>
struct LockedArrival {
  State<T> state;
  Vec2<T> heading;      ///< of the last arc, also where the ball rests; not a unit vector
  bool at_rest = false;
};

template <class T, class Motion>
LockedArrival<T> arrive_locked(const Motion& motion, State<T> state, const Vec2d& target, double capture, bool stop) {
  for (;;) {
    const Arc<T> arc = motion.arc(state);
    const T entry = capture > 0 && !stop ? first_entry(arc, target, capture, arc.duration) : T(forever);
    T t = entry <= arc.duration ? entry : arc.duration;
    bool arrived = entry <= arc.duration && entry < T(forever);
    if (!arrived && !stop) {
      const T nearest = closest_time(arc, arc.duration, target);
      arrived = nearest < arc.duration;
      if (arrived) t = nearest;
    }
    if (arrived || arc.end != PhaseEnd::roll) {
      const bool ends = !(t < T(forever));
      const State<T> end = ends ? state : advance(motion, state, arc, t);
      return {end, arrived ? end.velocity : arc.velocity, !arrived};
    }
    state = advance(motion, state, arc, t);
    motion.finish(state, arc);
  }
}

}  // namespace bankshot
