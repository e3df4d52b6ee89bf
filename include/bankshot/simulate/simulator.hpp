// SPDX-License-Identifier: MIT
//
// The forward simulator of one ball, event by event. `step()` moves the ball to its next event and
// says what it was; a caller that wants a record keeps one, so not recording costs nothing.
//
//   Simulator sim(boundary, motion, cushion, State<double>{at, velocity});
//   for (Event e = sim.step(); !e.final(); e = sim.step()) { ... sim.state() ... sim.arc() ... }
//
// Properties:
//  1. No allocation. The order of events is decided on values; times carry derivatives when T does.
//  2. One instant: a pocket captures before a cushion bounces; two cushions both bounce, larger
//     approach speed first, ties in the order of edges. Same instant means equal computed times.
//  3. The centre stays inside the boundary to tolerance::touch of the diagonal.
//  4. A bounce puts the centre exactly on the cushion's line, and the gap to a cushion just left
//     is exactly 0, so the same bounce is never found twice.
//  5. A ball at a cushion, with no speed away from it, that friction drives into it is held there:
//     its normal motion stops, its tangential motion goes on until the acceleration leaves. That is
//     no bounce; it ends the bouncing without end of a ball that returns slower each time.
#pragma once

#include <utility>

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/boundary.hpp"
#include "bankshot/simulate/roots.hpp"
#include "bankshot/tolerances.hpp"

namespace bankshot {

enum class EventKind { cushion, pocket, slide_to_roll, rest, horizon };

struct Event {
  EventKind kind = EventKind::horizon;
  int index = -1;             ///< contact of a cushion event, number of the pocket
  bool same_instant = false;  ///< the second of two cushions met at once
  /// True when the ball moves no more: at rest, pocketed, or stopped at the horizon.
  bool final() const { return kind != EventKind::cushion && kind != EventKind::slide_to_roll; }
};

template <class T, class Motion, class Cushion>
class Simulator {
 public:
  Simulator(const Boundary& boundary, const Motion& motion, const Cushion& cushion,
            const State<T>& start)
      : boundary_(&boundary), motion_(motion), cushion_(cushion), state_(start), time_(0) {
    using std::sqrt;
    const T w2 = start.spin.x * start.spin.x + start.spin.y * start.spin.y;
    const T launch2 = dot(start.velocity, start.velocity) + T(boundary.radius * boundary.radius) * w2;
    resting2_ = launch2 * T(tolerance::resting * tolerance::resting);
    if constexpr (!Motion::straight) find_touching();
  }

  /// Moves to the next event, or `horizon` seconds on if that comes first.
  Event step(const T& horizon = T(forever)) {
    if (pending_ >= 0) {
      const int second = std::exchange(pending_, -1);
      if (approach(second) > T(0)) {
        travelled_ = T(0);
        before_ = state_;
        arc_ = motion_.arc(state_);
        bounce(second);
        return {EventKind::cushion, second, true};
      }
    }
    before_ = state_;
    arc_ = motion_.arc(state_);
    if constexpr (!Motion::straight) hold();
    const Next next = find_next(horizon);
    travelled_ = next.time;
    if (!(next.time < T(forever))) {
      travelled_ = T(0);
      return {EventKind::horizon};
    }
    time_ += next.time;
    state_ = advance(motion_, before_, arc_, next.time);
    if (next.event.kind == EventKind::cushion) return cushions(next);
    if (next.time > T(0)) leave();
    if (next.event.kind == EventKind::rest || next.event.kind == EventKind::slide_to_roll)
      motion_.finish(state_, arc_);
    return next.event;
  }

  const State<T>& state() const { return state_; }  ///< right after the last event
  const State<T>& before() const { return before_; }  ///< where the last arc began
  const T& time() const { return time_; }           ///< seconds since the launch
  const Arc<T>& arc() const { return arc_; }        ///< the arc that led to the last event
  const T& travelled() const { return travelled_; }  ///< seconds spent on that arc

  /// Unit vector away from a contact, into the table, for the ball where it is now.
  Vec2<T> normal(int contact) const {
    const auto walls = static_cast<int>(boundary_->walls.size());
    if (contact < walls) return to<T>(boundary_->walls[static_cast<std::size_t>(contact)].normal);
    const Vec2<T> out = state_.at - to<T>(tip(contact).centre);
    return out / norm(out);
  }

 private:
  struct Next {
    T time;
    Event event;
    int second = -1;
  };

  const Circle& tip(int contact) const {
    for (const Circle& c : boundary_->tips)
      if (c.contact == contact) return c;
    return boundary_->tips.front();
  }

  T approach(int contact) const { return -dot(normal(contact), state_.velocity); }
  bool left(int contact) const { return contact == on_[0] || contact == on_[1]; }

  Next find_next(const T& horizon) const {
    constexpr EventKind ends[] = {EventKind::horizon, EventKind::slide_to_roll, EventKind::rest};
    Next next{arc_.duration, {ends[static_cast<int>(arc_.end)]}};
    if (horizon < next.time) next = {horizon, {EventKind::horizon}};
    const auto walls = static_cast<int>(boundary_->walls.size());
    for (int i = 0; i < walls; ++i) consider(next, i, wall_hit(i, next.time));
    for (const Circle& c : boundary_->tips)
      consider(next, c.contact, first_entry(arc_, c.centre, c.radius, next.time, left(c.contact)));
    for (const Circle& c : boundary_->pockets) {
      const T t = first_entry(arc_, c.centre, c.radius, next.time);
      if (t <= next.time && t < T(forever)) next = {t, {EventKind::pocket, c.contact}};
    }
    return next;
  }

  static void consider(Next& next, int contact, const T& t) {
    if (t < next.time)
      next = {t, {EventKind::cushion, contact}};
    else if (t == next.time && next.event.kind == EventKind::cushion && next.second < 0)
      next.second = contact;
  }

  /// When the arc meets wall i, if not after `limit`.
  T wall_hit(int i, const T& limit) const {
    using std::abs;
    const Wall& w = boundary_->walls[static_cast<std::size_t>(i)];
    T speed = dot(w.normal, arc_.velocity);
    if (Motion::straight && !(speed < T(0))) return T(forever);
    T gap = dot(w.normal, arc_.at) - T(w.offset);
    if (i == held_[0] || i == held_[1]) return T(forever);
    if (left(i)) {
      gap = T(0);
      if (abs(speed) < T(tolerance::along) * norm(arc_.velocity)) return T(forever);
    } else if (gap < T(0) && gap > T(-tolerance::touch * boundary_->diagonal)) {
      gap = T(0);
    }
    const T t = first_descent(gap, speed, T(dot(w.normal, arc_.acceleration)));
    if (boundary_->strictly_convex || !(t <= limit)) return t;
    const T s = dot(w.along, arc_.position(t));
    const double slack = tolerance::edge_end * boundary_->diagonal;
    return s >= T(w.begin - slack) && s <= T(w.end + slack) ? t : T(forever);
  }

  Event cushions(const Next& next) {
    int first = next.event.index, second = next.second;
    if (second >= 0 && approach(second) > approach(first)) std::swap(first, second);
    leave();
    if (second >= 0) settle(second);
    bounce(first);
    pending_ = second;
    return {EventKind::cushion, first};
  }

  /// A ball may start at rest against a cushion: then the gap there is 0 from the beginning.
  void find_touching() {
    using std::abs;
    const T near = T(tolerance::touch * boundary_->diagonal);
    int found = 0;
    for (int i = 0; i < static_cast<int>(boundary_->walls.size()) && found < 2; ++i) {
      const Wall& w = boundary_->walls[static_cast<std::size_t>(i)];
      const T s = dot(w.along, state_.at);
      if (abs(T(dot(w.normal, state_.at) - T(w.offset))) <= near && s >= T(w.begin) - near && s <= T(w.end) + near) on_[found++] = i;
    }
  }

  /// Where the ball rests on a cushion and friction drives it in: no normal motion on this arc.
  void hold() {
    held_[0] = held_[1] = -1;
    for (int k = 0; k < 2; ++k) {
      const int i = on_[k];
      if (i < 0 || i >= static_cast<int>(boundary_->walls.size())) continue;
      const Vec2<T> n = to<T>(boundary_->walls[static_cast<std::size_t>(i)].normal);
      const T speed = dot(n, arc_.velocity), acceleration = dot(n, arc_.acceleration);
      if (speed * speed > resting2_ || !(acceleration < T(0))) continue;
      held_[k] = i;
      arc_.velocity -= n * speed;
      arc_.acceleration -= n * acceleration;
    }
  }

  /// The ball has moved: it is at no cushion but those that hold it.
  void leave() {
    on_[0] = held_[0];
    on_[1] = held_[1];
  }

  /// Puts the centre exactly on the contact, and remembers that it is there.
  void settle(int contact) {
    if (contact < static_cast<int>(boundary_->walls.size())) {
      const Wall& w = boundary_->walls[static_cast<std::size_t>(contact)];
      state_.at -= to<T>(w.normal) * T(dot(w.normal, state_.at) - T(w.offset));
    }
    if (contact != on_[0]) on_[1] = std::exchange(on_[0], contact);
  }

  void bounce(int contact) {
    settle(contact);
    cushion_.bounce(state_, normal(contact));
  }

  const Boundary* boundary_;
  Motion motion_;
  Cushion cushion_;
  State<T> state_;
  T time_;
  State<T> before_{};
  Arc<T> arc_{};
  T travelled_{0};
  T resting2_{0};           ///< m²/s²: a ball that leaves a cushion slower than this may be held
  int on_[2] = {-1, -1};    ///< contacts the centre is exactly on
  int held_[2] = {-1, -1};  ///< of those, the ones friction drives it into
  int pending_ = -1;      ///< the second cushion of a corner, still to bounce
};

}  // namespace bankshot
