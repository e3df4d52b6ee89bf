// SPDX-License-Identifier: MIT
//
// The forward simulator of one ball, event by event. `step()` moves the ball to its next event and
// says what it was; a caller that wants a record keeps one, so not recording costs nothing.
//
//   Simulator sim(boundary, motion, cushion, State<double>{at, velocity});
//   for (Event e = sim.step(); !e.final(); e = sim.step()) { ... sim.state() ... sim.arc() ... }
//
// Properties (2: next_event.hpp; 4 and 5: on_cushions.hpp):
//  1. No allocation. Events are found and ordered on values; only the time of the one that happens gets
//     the derivatives of T, by the implicit function theorem (roots.hpp).
//  3. The centre stays inside the boundary to Boundary::touch.
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

#include "bankshot/detail/next_event.hpp"

namespace bankshot {

/// T: the scalar (scalar.hpp). `boundary` must outlive it.
template <class T, class Motion, class Cushion>
class Simulator {
 public:
  Simulator(const Boundary& boundary, const Motion& motion, const Cushion& cushion, const State<T>& start)
      : boundary_(&boundary),
        motion_(motion),
        cushion_(cushion),
        state_(start),
        time_(0),
        cushions_(squared_scale(start, boundary.radius)) {
    if constexpr (!Motion::straight) cushions_.settle_at_start(boundary, state_.at);
  }

  /// Moves to the next event, or `horizon` seconds on if that comes first.
  Event step(const T& horizon = T(forever)) {
    if (pending_) {
      const Contact second = std::exchange(pending_, {});
      if (approach(second) > Number(0)) return second_of_instant(second);
    }
    before_ = state_;
    arc_ = motion_.arc(state_);
    if constexpr (!Motion::straight) cushions_.hold(*boundary_, arc_);
    const T end = arc_.parameter(horizon);
    const Next next = EventFinder<Motion::straight, Number>{*boundary_, cushions_, value(arc_)}.next(value(end));
    if (!(next.time < Number(forever))) {
      travelled_ = T(0);
      return {EventKind::horizon};
    }
    travelled_ = lift_event(*boundary_, next, arc_, cushions_.on(next.event.contact), end);
    time_ += arc_.seconds(travelled_);
    state_ = advance(motion_, before_, arc_, travelled_);
    if (next.event.kind == EventKind::cushion) return first_of_instant(next);
    if (next.time > Number(0)) cushions_.leave();
    if (next.event.kind == EventKind::rest || next.event.kind == EventKind::slide_to_roll) motion_.finish(state_, arc_);
    return next.event;
  }

  const State<T>& state() const { return state_; }    ///< right after the last event
  const State<T>& before() const { return before_; }  ///< where the last arc began
  const T& time() const { return time_; }             ///< seconds since the launch
  const Arc<T>& arc() const { return arc_; }          ///< the arc that led to the last event
  const T& travelled() const { return travelled_; }   ///< how far on that arc: its parameter, seconds on most

  /// Unit vector away from a contact, into the table, for the ball where it is now.
  Vec2<T> normal(Contact contact) const { return boundary_->normal(contact, state_.at); }

  /// Goes on from another state at the same event, such as the same with fresh derivatives.
  void resume(const State<T>& state) { state_ = state; }

 private:
  using Number = Real<T>;
  using Next = NextEvent<Number>;

  Number approach(Contact contact) const {
    return -dot(boundary_->normal(contact, value(state_.at)), value(state_.velocity));
  }

  Event first_of_instant(const Next& next) {
    Contact first = next.event.contact, second = next.second;
    if (second && approach(second) > approach(first)) std::swap(first, second);
    cushions_.leave();
    if (second) cushions_.meet(second);
    bounce(first);
    pending_ = second;
    return {EventKind::cushion, first};
  }

  /// No time passes, but the instant of the second bounce has derivatives of its own.
  Event second_of_instant(Contact contact) {
    before_ = state_;
    arc_ = motion_.arc(state_);
    travelled_ = T(0);
    if (const Wall* const w = boundary_->line(contact); has_derivatives<T> && w) {
      travelled_ = lift_line(arc_, w->normal, w->offset, false, Number(0));
      time_ += travelled_;
      state_ = advance(motion_, before_, arc_, travelled_);
    }
    bounce(contact);
    return {EventKind::cushion, contact, true};
  }

  void bounce(Contact contact) {
    cushions_.settle(*boundary_, contact, state_.at);
    cushions_.bounces(squared_scale(state_, boundary_->radius));
    if (const Wall* const w = boundary_->line(contact))
      cushion_.bounce(state_, w->normal);
    else
      cushion_.bounce(state_, normal(contact));
    const Vec2<Number> v = value(state_.velocity);
    if (cushions_.is_rounding(dot(v, v))) state_.velocity = {T(0), T(0)};
    if (cushions_.is_still(squared_scale(state_, boundary_->radius))) {
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
  OnCushions<Number> cushions_;
  Contact pending_{};  ///< the second cushion of a corner, still to bounce
};

}  // namespace bankshot
