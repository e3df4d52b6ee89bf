// SPDX-License-Identifier: MIT
//
// The locked path follows a *given* route, with cushions on their infinite lines. Where the real path jumps from one
// cushion to another at a corner, the locked one stays smooth, as a root finder with derivatives needs. Two aims just
// either side of a corner have locked paths that differ by little. A bounce may lie at a slightly negative time if the
// ball is already past the line. Pockets are not seen: the real simulator decides afterwards.
#pragma once

#include <span>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/detail/bounce.hpp"
#include "bankshot/detail/on_path.hpp"
#include "bankshot/detail/roots/roots.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/arc.hpp"
#include "bankshot/simulate/route.hpp"
#include "bankshot/simulate/work.hpp"

namespace bankshot {

/// End of a locked path: at the end of its route, stopped while moving towards the next contact (more speed would
/// help), or moving away from it (another aim would help).
enum class LockedEnd { complete, fell_short, wrong_way };

/// A ball that a route may touch: the table as that ball sees it, and where it stands before.
struct StandingBall {
  int ball;
  const Boundary* boundary;
  Vec2d at;
};

/// The balls of a route. A boundary alone stands for the cue ball alone.
template <class C>
struct RouteBallsOf {
  const Boundary& struck;
  std::span<const StandingBall> others{};
  BallBallOf<C> law{};
  bool carom = false;  ///< after a meeting, the path goes on with the ball that hit the other

  RouteBallsOf(const Boundary& boundary) : struck(boundary) {}
  RouteBallsOf(const Boundary& boundary, std::span<const StandingBall> standing, const BallBallOf<C>& collision,
               bool stays)
      : struck(boundary), others(standing), law(collision), carom(stays) {}

  const StandingBall& standing(int ball) const {
    std::size_t i = 0;
    while (others[i].ball != ball) ++i;
    return others[i];
  }
  const Boundary& boundary(int ball) const { return ball == 0 ? struck : *standing(ball).boundary; }
};
using RouteBalls = RouteBallsOf<double>;

template <class T>
struct LockedPath {
  State<T> state;  ///< right after the last meeting
  T time;          ///< s since the launch
  int ball = 0;    ///< ball that the path ends with
  LockedEnd end = LockedEnd::complete;
  Work work{};
};

/// Returns whether an arc that leaves a line counts as starting on it: from at most `touch` [m] beyond, or where it
/// does not get back to the line.
template <class N>
bool starts_on(const N& gap, const N& speed, const N& acceleration, double touch) {
  return !(gap > N(0)) && (gap > N(-touch) || !(speed * speed > 2 * acceleration * gap));
}

/// Returns the time to the line of wall w. It is negative if the centre is already beyond the line and moves on. A
/// centre that comes back from beyond the line first crosses it, and meets it then.
template <class N>
N time_to_line(const Arc<N>& arc, const Wall& w, double touch) {
  using std::sqrt;
  const N speed = dot(w.normal, arc.velocity), a = dot(w.normal, arc.acceleration);
  const N gap = dot(w.normal, arc.at) - N(w.offset);
  if (!(speed < N(0))) return detail::first_descent(starts_on(gap, speed, a, touch) ? N(0) : gap, speed, a);
  // Without acceleration no square is taken, since it would underflow for the slowest approach.
  if (a == N(0)) return gap / -speed;
  const N discriminant = speed * speed - 2 * a * gap;
  return discriminant < N(0) ? N(forever) : N(2 * gap / (sqrt(discriminant) - speed));
}

template <class N>
N time_to_contact(const Boundary& boundary, const Arc<N>& arc, Contact contact) {
  if (const Wall* const w = boundary.line(contact)) return time_to_line(arc, *w, boundary.touch);
  const Circle* const rim = boundary.rim(contact);
  if (!rim) return N(forever);
  if (contact.kind == ContactKind::ball)
    return detail::first_touch(arc, rim->centre, rim->radius, boundary.touch, arc.duration);
  return detail::first_entry(arc, rim->centre, rim->radius, arc.duration);
}

/// Returns the time at which a contact is met, with the derivatives of the arc. A gap that counted as 0 adds none.
template <class T, class Motion>
T lift_contact(const Motion& motion, const Boundary& boundary, const State<T>& start, const Arc<T>& arc,
               Contact contact, const Real<T>& t) {
  if constexpr (has_chords<Motion>)
    if (arc.chord) return detail::lift_on_path(motion, boundary, start, arc, contact, false, true, t);
  const Wall* const w = boundary.line(contact);
  if (!w) return detail::lift_circle(arc, boundary.rim(contact)->centre, t);
  const auto across = [w](const auto& v) { return dot(w->normal, value(v)); };
  const Real<T> gap = across(arc.at) - Real<T>(w->offset), speed = across(arc.velocity);
  const bool on = !(speed < 0) && starts_on(gap, speed, across(arc.acceleration), boundary.touch);
  return detail::lift_line(arc, w->normal, w->offset, on, t);
}

/// Lets two balls collide. The path goes on with the ball that was hit, from where it stood; in a carom, with the
/// other.
template <class T, class C>
void meet_ball(const RouteBallsOf<C>& balls, Contact contact, LockedPath<T>& path) {
  const StandingBall& other = balls.standing(contact.index);
  State<T> met{to<T>(other.at), {T(0), T(0)}, {T(0), T(0), T(0)}};
  balls.law.collide(balls.boundary(path.ball).body, path.state, other.boundary->body, met);
  if (balls.carom) return;
  path.state = met;
  path.ball = other.ball;
}

/// Returns true if a path of many pieces has gone far from where its leg began. On a tilted table it might never end.
template <class Motion, class N>
bool is_lost(const Motion&, const Boundary& boundary, const Vec2<N>& from, const Vec2<N>& at) {
  if constexpr (!has_chords<Motion>) {
    return false;
  } else {
    constexpr double far = 3;  // diagonals
    const Vec2<N> way = at - from;
    return dot(way, way) > far * far * boundary.diagonal * boundary.diagonal;
  }
}

/// Follows a route. `start` is the state of the ball of its first meeting. After a meeting of two balls, the route is
/// that of the ball that goes on. `watch` sees each arc and how far it was followed. If it has a member `met`, that
/// sees the state right after each meeting.
template <class T, class C, class Motion, class Cushion, class Watch = Unwatched>
LockedPath<T> follow_locked(const RouteBallsOf<C>& balls, const Motion& motion, const Cushion& cushion,
                            std::span<const Meeting> route, const State<T>& start, Watch&& watch = {}) {
  using Number = Real<T>;
  LockedPath<T> path{start, T(0), route.empty() ? 0 : route.front().ball};
  for (const Meeting& meeting : route) {
    const Contact contact = meeting.with;
    const Boundary& boundary = balls.boundary(path.ball);
    const Vec2<Number> from = value(path.state.at);
    for (;;) {
      const Arc<T> arc = motion.arc(boundary.body, path.state);
      ++path.work.arcs;
      const Number t = time_to_contact(boundary, value(arc), contact);
      const bool met = t <= value(arc.duration) && t < Number(forever);
      if (!met && (!arc.goes_on() || is_lost(motion, boundary, from, value(arc.at)))) {
        const bool towards = dot(boundary.normal(contact, value(arc.at)), value(arc.velocity)) < Number(0);
        path.end = towards ? LockedEnd::fell_short : LockedEnd::wrong_way;
        return path;
      }
      const T on = met ? lift_contact(motion, boundary, path.state, arc, contact, t) : arc.duration;
      watch(arc, on);
      path.time += arc.seconds(on);
      path.state = advance(motion, boundary.body, path.state, arc, on);
      if (met) break;
      motion.finish(boundary.body, path.state, arc);
    }
    if (contact.kind == ContactKind::ball)
      meet_ball(balls, contact, path);
    else
      detail::bounce_at(boundary, cushion, contact, path.state);
    ++path.work.impacts;
    if constexpr (requires { watch.met(path.state); }) watch.met(path.state);
  }
  return path;
}

/// Follows a route of the cue ball alone.
template <class T, class Motion, class Cushion, class Watch = Unwatched>
LockedPath<T> follow_locked(const Boundary& boundary, const Motion& motion, const Cushion& cushion,
                            std::span<const Meeting> route, const State<T>& start, Watch&& watch = {}) {
  return follow_locked(RouteBalls(boundary), motion, cushion, route, start, watch);
}

/// End of the last leg of a locked path. The ball is abreast of the target, enters the circle of radius `capture`
/// around it, or comes to rest.
template <class T>
struct LockedArrival {
  State<T> state;
  Vec2<T> heading;  ///< direction of the last arc, even if the ball rests; not a unit vector
  bool at_rest = false;
  T time{0};  ///< s since the leg began; infinite if it never ends
  Work work{};
};

template <class T, class Motion, class Watch = Unwatched>
LockedArrival<T> arrive_locked(const Motion& motion, const Body& body, State<T> state, const Vec2d& target,
                               double capture, bool stop, Watch&& watch = {}) {
  using Number = Real<T>;
  Work work;
  for (T time(0);;) {
    const Arc<T> arc = motion.arc(body, state);
    ++work.arcs;
    const Arc<Number>& plain = value(arc);
    T t = arc.duration;
    bool arrived = false;
    if (capture > 0 && !stop) {
      const Number entry = detail::first_entry(plain, target, capture, plain.duration);
      arrived = entry <= plain.duration && entry < Number(forever);
      if (arrived) t = detail::lift_circle(arc, target, entry);
    }
    if (!arrived && !stop) {
      const Number nearest = detail::closest_time(plain, plain.duration, target);
      arrived = nearest < plain.duration;
      if (arrived) t = nearest > Number(0) ? detail::lift_closest(arc, target, nearest) : T(0);
    }
    if (t < T(forever)) watch(arc, t);
    time += arc.seconds(t);
    if (arrived || !arc.goes_on()) {
      const bool ends = !(t < T(forever));
      const State<T> end = ends ? state : advance(motion, body, state, arc, t);
      return {end, arrived ? end.velocity : arc.velocity, !arrived, time, work};
    }
    state = advance(motion, body, state, arc, t);
    motion.finish(body, state, arc);
  }
}

}  // namespace bankshot
