// SPDX-License-Identifier: MIT
//
// The first thing an arc meets: a cushion, a vertex, a jaw, a pocket, a ball at rest, its own end or the horizon.
// Events are found and ordered on values. `lift_event` then gives the time of the one that happens its derivatives.
// Property, numbered as in simulator.hpp:
//  2. One instant: a pocket captures before balls meet, and of two balls the one with the larger approach speed meets
//     first. Then a cushion bounces. Two cushions both bounce, larger approach speed first, ties in the order of edges.
//     Same instant means equal computed times.
#pragma once

#include <algorithm>

#include "bankshot/detail/on_cushions.hpp"
#include "bankshot/detail/roots/roots.hpp"
#include "bankshot/simulate/event.hpp"

namespace bankshot::detail {

template <class N>
struct NextEvent {
  N time;  ///< the arc's parameter
  Event event;
  Contact second{};    ///< another cushion met at the same time
  bool piece = false;  ///< no event: a piece of the path ends, and the motion goes on

  /// Sets the members one by one. A whole struct would be built in memory and waited for, at each cushion.
  void set(const N& t, EventKind kind, Contact contact) {
    time = t;
    event.kind = kind;
    event.contact.kind = contact.kind;
    event.contact.index = contact.index;
    second.kind = ContactKind::none;
    piece = false;
  }
};

/// `straight`: no arc of the motion bends.
template <bool straight, class N>
struct EventFinder {
  const Boundary& boundary;
  const OnCushions<N>& cushions;
  const Arc<N>& arc;

  NextEvent<N> next(const N& horizon) const {
    NextEvent<N> first;
    meet_nothing(first, horizon);
    for (const Wall& w : boundary.walls) consider(first, w.contact, wall_hit(w, first.time));
    if (boundary.jaws.empty()) {
      if (!boundary.tips.empty() || !boundary.pockets.empty()) consider_circles(first);
    } else if (is_at_mouth(first)) {
      meet_nothing(first, horizon);
      consider_rails_and_jaws(first);
    }
    if (!boundary.balls.empty()) consider_balls(first);
    return first;
  }

 private:
  void meet_nothing(NextEvent<N>& first, const N& horizon) const {
    constexpr EventKind ends[] = {EventKind::horizon, EventKind::slide_to_roll, EventKind::rest, EventKind::horizon};
    first.set(arc.duration, ends[static_cast<int>(arc.end)], {});
    first.piece = arc.end == PhaseEnd::piece;
    if (horizon < first.time) first.set(horizon, EventKind::horizon, {});
  }

  /// Considers vertices and pockets. Walls are treated separately, so that a table without vertices and pockets pays
  /// nothing.
  void consider_circles(NextEvent<N>& first) const {
    const Reach<N> reach(arc, first.time, N(boundary.touch));
    for (const Circle& c : boundary.tips)
      if (!reach.misses(c.centre, c.radius)) consider_tip(first, c);
    for (const Circle& c : boundary.pockets)
      if (!reach.misses(c.centre, c.radius)) consider_pocket(first, c);
  }

  /// Returns true if rails alone do not decide what comes first. The ball crosses a rail's line at a mouth, has done
  /// so, or is held by a rail that ends there.
  bool is_at_mouth(const NextEvent<N>& first) const {
    if (cushions.any_holds()) return true;
    const auto breached = [&](Contact rail) {
      return mouth_at(boundary.walls[static_cast<std::size_t>(rail.index)], first.time) >= 0;
    };
    if (first.event.bounces() && (breached(first.event.contact) || (first.second && breached(first.second))))
      return true;
    return between_jaws() >= 0;
  }

  /// Returns the pocket in whose mouth the arc crosses a rail's line, or -1 if the rail is whole there. A ball that a
  /// rail held up to its end, and that goes on, is in the mouth.
  int mouth_at(const Wall& w, const N& t) const {
    const double s = static_cast<double>(dot(w.along, arc.position(t)));
    const int pocket = boundary.break_at(w, s);
    if (pocket >= 0 || t > N(0)) return pocket;
    return boundary.break_at(w, s + (dot(w.along, arc.velocity) < N(0) ? -boundary.touch : boundary.touch));
  }

  /// Returns the pocket between whose jaws the arc starts, or -1 if it starts on the table or on a rail.
  int between_jaws() const { return cushions.on_rail() ? -1 : boundary.between_jaws(arc.at); }

  void consider_tip(NextEvent<N>& first, const Circle& c) const {
    if (cushions.held(c.contact) || passes_tangent(c)) return;
    const N t = first_entry(arc, c.centre, c.radius, first.time, cushions.on(c.contact));
    if (t < N(forever) && c.covers(arc.position(t))) consider(first, c.contact, t);
  }

  void consider_pocket(NextEvent<N>& first, const Circle& c) const {
    const N t = first_entry(arc, c.centre, c.radius, first.time);
    if (t <= first.time && t < N(forever)) first.set(t, EventKind::pocket, c.contact);
  }

  /// Considers rails, and the jaws of the few pockets that the arc may enter. A centre leaves the rectangle of centres
  /// only between the jaws of a pocket, so a leg that ends at a rail needs no jaws.
  void consider_rails_and_jaws(NextEvent<N>& first) const {
    int pockets[4];
    int count = 0;
    const auto look = [&](int pocket) {
      if (pocket >= 0 && std::find(pockets, pockets + count, pocket) == pockets + count && count < 4)
        pockets[count++] = pocket;
    };
    look(between_jaws());
    for (const Wall& w : boundary.walls) {
      const N t = wall_hit(w, first.time);
      if (!(t <= first.time) || !(t < N(forever))) continue;
      const int pocket = mouth_at(w, t);
      pocket < 0 ? consider(first, w.contact, t) : look(pocket);
    }
    for (int i = 0; i < count; ++i) consider_jaws(first, pockets[i]);
    for (const Wall& w : boundary.walls)
      if (cushions.held(w.contact)) end_hold(first, w);
  }

  /// Ends a piece of the arc where the rail that holds the ball ends.
  void end_hold(NextEvent<N>& first, const Wall& w) const {
    const N s = dot(w.along, arc.at), speed = dot(w.along, arc.velocity), a = dot(w.along, arc.acceleration);
    const auto [low, high] = boundary.whole_around(w, static_cast<double>(s));
    for (const N& t : {first_descent(N(s - N(low)), speed, a), first_descent(N(N(high) - s), N(-speed), N(-a))})
      if (t < first.time) {
        first.set(t, EventKind::horizon, {});
        first.piece = true;
      }
  }

  void consider_jaws(NextEvent<N>& first, int pocket) const {
    const auto k = static_cast<std::size_t>(pocket);
    const JawWalls& jaws = boundary.jaws[k];
    for (const Circle& tip : jaws.tips) consider_tip(first, tip);
    if (jaws.faced)
      for (const Wall& f : jaws.facings) {
        const N t = wall_hit(f, first.time);
        if (t <= first.time && ends_hold(f, t)) consider(first, f.contact, t);
      }
    consider_pocket(first, boundary.pockets[k]);
  }

  /// Considers balls at rest. In the same instant, a ball comes before a cushion and after a pocket.
  void consider_balls(NextEvent<N>& first) const {
    const Reach<N> reach(arc, first.time, N(boundary.touch));
    for (const Circle& ball : boundary.balls) {
      if (reach.misses(ball.centre, ball.radius)) continue;
      const N t = first_touch(arc, ball.centre, ball.radius, boundary.touch, first.time);
      if (!(t <= first.time) || !(t < N(forever))) continue;
      const EventKind kind = first.event.kind;
      const bool later = t == first.time &&
                         (kind == EventKind::pocket || (kind == EventKind::ball && !approaches_faster(ball, first)));
      if (!later) first.set(t, EventKind::ball, ball.contact);
    }
  }

  /// Returns true if the arc approaches `ball` faster than the ball that it meets in the same instant.
  bool approaches_faster(const Circle& ball, const NextEvent<N>& first) const {
    const Vec2<N> at = arc.position(first.time), v = arc.tangent(first.time);
    const auto speed = [&](const Circle& c) {
      const Vec2<N> d = to<N>(c.centre) - at;
      return N(dot(d, v) / norm(d));
    };
    return speed(ball) > speed(*boundary.rim(first.event.contact));
  }

  static void consider(NextEvent<N>& first, Contact contact, const N& t) {
    if (t < first.time)
      first.set(t, bounce_off(contact), contact);
    else if (t == first.time && first.event.bounces() && !first.second)
      first.second = contact;
  }

  /// Returns when the arc meets a wall. A result after `limit` only means that it does not do so before.
  N wall_hit(const Wall& w, const N& limit) const {
    const N speed = dot(w.normal, arc.velocity);
    if (straight && !(speed < N(0))) return N(forever);
    N gap = dot(w.normal, arc.at) - N(w.offset);
    const N acceleration = dot(w.normal, arc.acceleration);
    // If an arc bends towards the wall, or not at all, its gap is least at one end.
    if (gap > N(0) && !(acceleration > N(0)) && limit < N(forever) &&
        gap + (speed + acceleration * (limit * 0.5)) * limit > N(boundary.touch))
      return N(forever);
    if (cushions.held(w.contact)) return N(forever);
    if (cushions.on(w.contact)) {
      gap = N(0);
      if (cushions.is_rounding(speed * speed)) return N(forever);
    } else if (gap < N(boundary.touch) && gap > N(-boundary.touch)) {
      if (gap < N(0)) gap = N(0);
      if (runs_parallel(speed, acceleration)) return N(forever);
    }
    const N t = first_descent(gap, speed, acceleration);
    return boundary.strictly_convex || !(t <= limit) || ends_hold(w, t) ? t : N(forever);
  }

  /// Returns true if the ball's foot on the wall's line is between the wall's ends at this time.
  bool ends_hold(const Wall& w, const N& t) const {
    const N s = dot(w.along, arc.position(t));
    const double slack = tolerance::edge_end * boundary.extent;
    return s >= N(w.begin - slack) && s <= N(w.end + slack) && !starts_past(w, s);
  }

  /// Returns true if a point starts at a vertex that points into the table, and goes past the end of this wall. It
  /// meets the wall there, at `s` along it, only if it approaches the other cushion too.
  bool starts_past(const Wall& w, const N& s) const {
    using std::abs;
    if (boundary.body.radius > 0) return false;
    const auto at = [&](double end, const N& along) { return abs(N(along - N(end))) <= N(boundary.touch); };
    const N start = dot(w.along, arc.at);
    const std::size_t walls = boundary.walls.size(), i = static_cast<std::size_t>(w.contact.index);
    const auto turns_in = [&](const Wall& before, const Wall& after) { return cross(before.along, after.along) < 0; };
    const auto leaves = [&](const Wall& other) { return !(dot(other.normal, arc.velocity) < N(0)); };
    if (at(w.end, s) && at(w.end, start)) {
      const Wall& after = boundary.walls[(i + 1) % walls];
      return turns_in(w, after) && leaves(after);
    }
    if (at(w.begin, s) && at(w.begin, start)) {
      const Wall& before = boundary.walls[(i + walls - 1) % walls];
      return turns_in(before, w) && leaves(before);
    }
    return false;
  }

  /// Returns true if the speed to or from a line is only the rounding of the velocity, now and at the end of the arc.
  bool runs_parallel(const N& speed, const N& acceleration) const {
    const N noise2 = dot(arc.velocity, arc.velocity) * (tolerance::along * tolerance::along);
    if (!(speed * speed < noise2)) return false;
    const N gained = acceleration == 0 ? N(0) : N(acceleration * arc.duration);
    return gained * gained < noise2;
  }

  /// Returns true if the ball runs along a cushion that ends at this tip. The cushion's line is exactly tangent to the
  /// tip.
  bool passes_tangent(const Circle& tip) const {
    for (const Contact beside : {tip.before, tip.after}) {
      if (cushions.held(beside)) return true;
      if (!cushions.on(beside)) continue;
      const N speed = dot(boundary.normal(beside, arc.at), arc.velocity);
      if (cushions.is_rounding(speed * speed)) return true;
    }
    return false;
  }
};

/// Returns the time of an event that was found, with the derivatives of the arc. `on`: the arc starts exactly on the
/// line of the event's cushion.
template <class T>
T lift_event(const Boundary& boundary, const NextEvent<Real<T>>& next, const Arc<T>& arc, bool on, const T& horizon) {
  if constexpr (!has_derivatives<T>) return next.time;
  const Contact contact = next.event.contact;
  switch (next.event.kind) {
    case EventKind::cushion:
    case EventKind::jaw:
      if (const Wall* const w = boundary.line(contact)) return lift_line(arc, w->normal, w->offset, on, next.time);
      return lift_circle(arc, boundary.rim(contact)->centre, next.time);
    case EventKind::pocket:
    case EventKind::ball:
      return lift_circle(arc, boundary.rim(contact)->centre, next.time);
    case EventKind::horizon:
      if (!next.piece) return horizon;
      return next.time < value(arc.duration) ? T(next.time) : arc.duration;  // the rail that holds the ball ends
    default:
      return arc.duration;
  }
}

}  // namespace bankshot::detail
