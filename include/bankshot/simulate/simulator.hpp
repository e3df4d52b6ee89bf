// SPDX-License-Identifier: MIT
//
// The forward simulator of one ball, event by event. `step()` moves the ball to its next event and
// says what it was; a caller that wants a record keeps one, so not recording costs nothing.
//
//   Simulator sim(boundary, motion, cushion, State<double>{at, velocity});
//   for (Event e = sim.step(); !e.final(); e = sim.step()) { ... sim.state() ... sim.arc() ... }
//
// Properties:
//  1. No allocation. Events are found and ordered on values; only the time of the one that happens gets
//     the derivatives of T, by the implicit function theorem (roots.hpp).
//  2. One instant: a pocket captures before a cushion bounces; two cushions both bounce, larger
//     approach speed first, ties in the order of edges. Same instant means equal computed times.
//  3. The centre stays inside the boundary to Boundary::touch.
//  4. A bounce puts the centre exactly on the cushion's line, and the gap to a cushion just left
//     is exactly 0, so the same bounce is never found twice.
//  5. A ball at a cushion, with no speed away from it, that friction drives into it is held there:
//     its normal motion stops, its tangential motion goes on until the acceleration leaves. That is
//     no bounce; it ends the bouncing without end of a ball that returns slower each time. A ball that
//     starts within Boundary::touch of a cushion is put on its line. Limitation: at a reflex vertex the ball
//     goes on along the tangent, where friction might take it round. A ball slower than
//     tolerance::still of its launch after a bounce rests.
//  6. Error. The walls and constants are the given doubles. With T = double the position of the last
//     event differs from the exact one of the same start state by
//       |error| <= C · 2⁻⁵³ · size · κ,   C = tolerance::simulation_error,   size = Boundary::extent,
//       κ = Σ_k ‖J_k D_k‖ / size over the start (k = 0) and every event before the last.
//     J_k: Jacobian of that position by the state after event k (x, y, v, ω), D_k = diag(size, size, V,
//     V, V/R, V/R, V/R), V = |v| + R|ω| where the arc that led to event k began. Each event rounds the
//     state anew by a few units in the last place. The start alone would not do: a bounce forgets
//     the gap, and so what was wrong with it, while a ball that then leaves slowly along the cushion
//     multiplies what the bounce has rounded. The bound holds as long as both runs meet the same events; they may
//     differ only where two events lie within that bound of each other, or a cushion is grazed that closely.
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
    bounced2_ = squared_scale();
    resting2_ = bounced2_ * (tolerance::resting * tolerance::resting);
    still2_ = bounced2_ * (tolerance::still * tolerance::still);
    if constexpr (!Motion::straight) find_touching();
  }

  /// Moves to the next event, or `horizon` seconds on if that comes first.
  Event step(const T& horizon = T(forever)) {
    if (pending_ >= 0) {
      const int second = std::exchange(pending_, -1);
      if (approach(second) > Number(0)) return second_of_instant(second);
    }
    before_ = state_;
    arc_ = motion_.arc(state_);
    if constexpr (!Motion::straight) hold();
    const T end = arc_.parameter(horizon);
    const Next next = find_next(value(arc_), value(end));
    if (!(next.time < Number(forever))) {
      travelled_ = T(0);
      return {EventKind::horizon};
    }
    travelled_ = lift(next, end);
    time_ += arc_.seconds(travelled_);
    state_ = advance(motion_, before_, arc_, travelled_);
    if (next.event.kind == EventKind::cushion) return cushions(next);
    if (next.time > Number(0)) leave();
    if (next.event.kind == EventKind::rest || next.event.kind == EventKind::slide_to_roll)
      motion_.finish(state_, arc_);
    return next.event;
  }

  const State<T>& state() const { return state_; }  ///< right after the last event
  const State<T>& before() const { return before_; }  ///< where the last arc began
  const T& time() const { return time_; }           ///< seconds since the launch
  const Arc<T>& arc() const { return arc_; }        ///< the arc that led to the last event
  const T& travelled() const { return travelled_; }  ///< how far on that arc: its parameter, seconds on most

  /// Goes on from another state at the same event, such as the same with fresh derivatives.
  void resume(const State<T>& state) { state_ = state; }

  /// Unit vector away from a contact, into the table, for the ball where it is now.
  Vec2<T> normal(int contact) const {
    if (is_wall(contact)) return to<T>(wall(contact).normal);
    const Vec2<T> out = state_.at - to<T>(tip(contact).centre);
    return out / norm(out);
  }

 private:
  using Number = Real<T>;
  struct Next {
    Number time;
    Event event;
    int second = -1;
  };

  bool is_wall(int contact) const { return contact < static_cast<int>(boundary_->walls.size()); }
  const Wall& wall(int contact) const { return boundary_->walls[static_cast<std::size_t>(contact)]; }
  const Circle& tip(int contact) const {
    for (const Circle& c : boundary_->tips)
      if (c.contact == contact) return c;
    return boundary_->tips.front();
  }

  Number approach(int contact) const { return -dot(value(normal(contact)), value(state_.velocity)); }
  bool held(int contact) const { return contact == held_[0] || contact == held_[1]; }
  bool left(int contact) const { return contact == on_[0] || contact == on_[1]; }

  /// v² + (Rω)² of the part of the spin that moves the ball.
  Number squared_scale() const {
    const Vec2<Number> v = value(state_.velocity), w{value(state_.spin.x), value(state_.spin.y)};
    return dot(v, v) + Number(boundary_->radius) * boundary_->radius * dot(w, w);
  }

  Next find_next(const Arc<Number>& arc, const Number& horizon) const {
    constexpr EventKind ends[] = {EventKind::horizon, EventKind::slide_to_roll, EventKind::rest};
    Next next{arc.duration, {ends[static_cast<int>(arc.end)]}};
    if (horizon < next.time) next = {horizon, {EventKind::horizon}};
    const auto walls = static_cast<int>(boundary_->walls.size());
    for (int i = 0; i < walls; ++i) consider(next, i, wall_hit(arc, i, next.time));
    for (const Circle& c : boundary_->tips)
      if (!held(c.contact) && !passes_tangent(c.contact, arc)) consider(next, c.contact, first_entry(arc, c.centre, c.radius, next.time, left(c.contact)));
    for (const Circle& c : boundary_->pockets) {
      const Number t = first_entry(arc, c.centre, c.radius, next.time);
      if (t <= next.time && t < Number(forever)) next = {t, {EventKind::pocket, c.contact}};
    }
    return next;
  }

  /// The ball runs along a cushion that ends at this vertex: the line touches the tip's arc there, exactly.
  bool passes_tangent(int contact, const Arc<Number>& arc) const {
    const int walls = static_cast<int>(boundary_->walls.size()), vertex = contact - walls;
    for (const int i : {vertex, (vertex + walls - 1) % walls})
      if (held(i) || (left(i) && runs_along(dot(wall(i).normal, arc.velocity)))) return true;
    return false;
  }
  /// Speed to and from a line, now and when the arc ends, is the rounding of the velocity.
  static bool parallel(const Arc<Number>& arc, const Number& speed, const Number& acceleration) {
    const Number noise2 = dot(arc.velocity, arc.velocity) * (tolerance::along * tolerance::along);
    if (!(speed * speed < noise2)) return false;
    const Number gained = acceleration == 0 ? Number(0) : Number(acceleration * arc.duration);
    return gained * gained < noise2;
  }
  bool runs_along(const Number& speed) const { return speed * speed < bounced2_ * (tolerance::along * tolerance::along); }

  static void consider(Next& next, int contact, const Number& t) {
    if (t < next.time)
      next = {t, {EventKind::cushion, contact}};
    else if (t == next.time && next.event.kind == EventKind::cushion && next.second < 0)
      next.second = contact;
  }

  /// When the arc meets wall i, if not after `limit`.
  Number wall_hit(const Arc<Number>& arc, int i, const Number& limit) const {
    const Wall& w = wall(i);
    const Number speed = dot(w.normal, arc.velocity);
    if (Motion::straight && !(speed < Number(0))) return Number(forever);
    Number gap = dot(w.normal, arc.at) - Number(w.offset);
    const Number acceleration = dot(w.normal, arc.acceleration);
    // The gap of an arc that bends towards the wall, or not at all, is least at an end.
    if (gap > Number(0) && !(acceleration > Number(0)) && limit < Number(forever) &&
        gap + (speed + acceleration * (limit * 0.5)) * limit > Number(boundary_->touch))
      return Number(forever);
    if (held(i)) return Number(forever);
    if (left(i)) {
      gap = Number(0);
      if (runs_along(speed)) return Number(forever);
    } else if (gap < Number(boundary_->touch) && gap > Number(-boundary_->touch)) {
      if (gap < Number(0)) gap = Number(0);
      if (parallel(arc, speed, acceleration)) return Number(forever);
    }
    const Number t = first_descent(gap, speed, acceleration);
    if (boundary_->strictly_convex || !(t <= limit)) return t;
    const Number s = dot(w.along, arc.position(t));
    const double slack = tolerance::edge_end * boundary_->extent;
    return s >= Number(w.begin - slack) && s <= Number(w.end + slack) ? t : Number(forever);
  }

  /// The time of an event that was found, with the derivatives of T.
  T lift(const Next& next, const T& horizon) const {
    if (next.event.kind == EventKind::cushion && is_wall(next.event.index)) {
      const Wall& w = wall(next.event.index);
      return lift_line(arc_, w.normal, w.offset, left(next.event.index), next.time);
    }
    if (next.event.kind == EventKind::cushion) {
      const Circle& c = tip(next.event.index);
      return lift_circle(arc_, c.centre, next.time);
    }
    if (next.event.kind == EventKind::pocket) {
      const Circle& c = boundary_->pockets[static_cast<std::size_t>(next.event.index)];
      return lift_circle(arc_, c.centre, next.time);
    }
    return next.event.kind == EventKind::horizon ? horizon : arc_.duration;
  }

  /// No time passes, but the instant of the second bounce has derivatives of its own.
  Event second_of_instant(int contact) {
    before_ = state_;
    arc_ = motion_.arc(state_);
    travelled_ = T(0);
    if (has_derivatives<T> && is_wall(contact)) {
      travelled_ = lift_line(arc_, wall(contact).normal, wall(contact).offset, false, Number(0));
      time_ += travelled_;
      state_ = advance(motion_, before_, arc_, travelled_);
    }
    bounce(contact);
    return {EventKind::cushion, contact, true};
  }

  Event cushions(const Next& next) {
    int first = next.event.index, second = next.second;
    if (second >= 0 && approach(second) > approach(first)) std::swap(first, second);
    leave();
    if (second >= 0) meet(second);
    bounce(first);
    pending_ = second;
    return {EventKind::cushion, first};
  }

  /// A ball may start at rest against a cushion: then it is put on the line, and the gap is 0.
  void find_touching() {
    using std::abs;
    const Number near(boundary_->touch);
    const Vec2<Number> at = value(state_.at);
    int found = 0;
    for (int i = 0; i < static_cast<int>(boundary_->walls.size()) && found < 2; ++i) {
      const Wall& w = wall(i);
      const Number s = dot(w.along, at), gap = dot(w.normal, at) - Number(w.offset);
      if (abs(gap) <= near && s >= w.begin - near && s <= w.end + near) {
        settle(i);
        ++found;
      }
    }
  }

  /// Where the ball rests on a cushion and friction drives it in: no normal motion on this arc. Between
  /// two cushions it may be held by one, along which the other lets it go, or by both: then it stays.
  void hold() {
    held_[0] = held_[1] = -1;
    if (on_[0] < 0) return;
    const int corner = corner_to_crawl_in();
    const int at[] = {on_[0], corner >= 0 ? corner : on_[1]};
    const bool slow[] = {corner >= 0 || rests_at(at[0]), corner >= 0 || rests_at(at[1])};
    if (!slow[0] && !slow[1]) return;
    const Vec2<Number> a = value(arc_.acceleration);
    bool pressed = false;
    for (int k = 0; k < 2; ++k) {
      if (!slow[k]) continue;
      const Vec2<Number> n = value(normal(at[k]));
      const Number into = dot(n, a);
      if (!brings_back(into, dot(n, value(arc_.velocity)))) continue;
      pressed = true;
      const Vec2<Number> along{a.x - into * n.x, a.y - into * n.y};
      if (slow[1 - k] && dot(value(normal(at[1 - k])), along) < 0) continue;
      held_[k] = on_[k] = at[k];
      stop_along(n, arc_.velocity);
      stop_along(n, arc_.acceleration);
      return;
    }
    if (!pressed) return;
    for (int k = 0; k < 2; ++k) held_[k] = on_[k] = at[k];
    arc_.velocity = arc_.acceleration = {T(0), T(0)};
  }

  /// The arc ends with a speed towards the cushion. Otherwise the ball is not pressed to it, and an acceleration
  /// along the cushion, whose normal part has the sign of rounding, decides nothing. A ball that rolls away
  /// ends with speed 0, up to rounding: a hundredth more tells them apart.
  bool brings_back(const Number& acceleration, const Number& speed) const {
    using std::abs;
    return acceleration < 0 && -acceleration * value(arc_.duration) > 1.01 * abs(speed);
  }

  /// Where the ball is at a cushion in a corner and hardly moves: the other cushion, else -1. Friction into
  /// the corner and spin at the cushions may feed ever the same tiny bounces from one to the other.
  int corner_to_crawl_in() const {
    using std::abs;
    const Vec2<Number> at = value(arc_.at), v = value(arc_.velocity);
    constexpr double more = tolerance::crawling / tolerance::resting;
    if (dot(v, v) > resting2_ * (more * more) || !is_wall(on_[0])) return -1;
    for (int i = 0; i < static_cast<int>(boundary_->walls.size()); ++i)
      if (i != on_[0] && abs(Number(dot(wall(i).normal, at) - Number(wall(i).offset))) <= Number(boundary_->touch)) return i;
    return -1;
  }

  /// The ball is at this contact without speed from or towards it, to speak of.
  bool rests_at(int contact) const {
    if (contact < 0) return false;
    const Number speed = dot(value(normal(contact)), value(arc_.velocity));
    return speed * speed <= resting2_;
  }

  static void stop_along(const Vec2<Number>& n, Vec2<T>& v) {
    const T part = dot(n, v);
    v -= {part * n.x, part * n.y};
  }

  /// The ball has moved: it is at no cushion but those that hold it.
  void leave() {
    on_[0] = held_[0];
    on_[1] = held_[1];
  }

  /// Puts the centre exactly on the contact, and remembers that it is there.
  void settle(int contact) {
    if (is_wall(contact)) {
      const Wall& w = wall(contact);
      const T gap = dot(w.normal, state_.at) - Number(w.offset);
      state_.at -= {gap * w.normal.x, gap * w.normal.y};
    }
    meet(contact);
  }

  /// Remembers that the centre is on the contact.
  void meet(int contact) {
    if (contact != on_[0]) on_[1] = std::exchange(on_[0], contact);
  }

  void bounce(int contact) {
    settle(contact);
    bounced2_ = squared_scale();
    if (is_wall(contact))
      cushion_.bounce(state_, wall(contact).normal);
    else
      cushion_.bounce(state_, normal(contact));
    const Vec2<Number> v = value(state_.velocity);
    if (dot(v, v) < bounced2_ * (tolerance::along * tolerance::along)) state_.velocity = {T(0), T(0)};  // rounding
    if (squared_scale() < still2_) {
      state_.velocity = {T(0), T(0)};
      state_.spin.x = state_.spin.y = T(0);
    }
  }

  const Boundary* boundary_;
  Motion motion_;
  Cushion cushion_;
  State<T> state_;
  T time_;
  State<T> before_{};
  Arc<T> arc_{};
  T travelled_{0};
  // Squares of speeds [m²/s²]:
  Number bounced2_{0};  ///< before the last bounce; its roundings are in proportion
  Number resting2_{0};  ///< a ball that leaves a cushion slower than this may be held
  Number still2_{0};    ///< a ball slower than this after a bounce rests
  int on_[2] = {-1, -1};    ///< contacts the centre is exactly on
  int held_[2] = {-1, -1};  ///< of those, the ones friction drives it into
  int pending_ = -1;      ///< the second cushion of a corner, still to bounce
};

}  // namespace bankshot
