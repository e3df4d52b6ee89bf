// SPDX-License-Identifier: MIT
//
// The forward simulator of one ball, event by event. `step()` moves the ball to its next event and returns it. A caller
// that wants a record keeps one, so not recording costs nothing.
//
//   Simulator sim(boundary, motion, cushion, State<double>{at, velocity});
//   for (Event e = sim.step(); !e.final(); e = sim.step()) { ... sim.state() ... sim.arc() ... }
//
// Properties (2: detail/next_event.hpp; 4 and 5: detail/on_cushions.hpp):
//  1. No allocation. Events are found and ordered on values. Only the time of the one that happens gets the
//     derivatives of T, by the implicit function theorem (roots.hpp).
//  3. The centre stays inside the boundary to Boundary::touch.
//  6. Error. The walls and constants are the given doubles. With T = double the position of the last
//     event differs from the exact one of the same start state by
//       |error| <= C · 2⁻⁵³ · size · κ,   C = tolerance::simulation_error,   size = Boundary::extent,
//       (2⁻⁵³ times tolerance::pieces_rounding if the table leans, since each piece of a path rounds)
//       κ = Σ_k ‖J_k D_k‖ / size over the start (k = 0) and every event before the last.
//     J_k is the Jacobian of that position by the state after event k (x, y, v, ω). D_k is diag(size, size, V,
//     V, V/R, V/R, V/R), with V = |v| + R|ω| where the arc that led to event k began. Each event rounds the
//     state anew by a few units in the last place. The start alone would not do. A bounce forgets the gap, and
//     with it the error of the gap. But a ball that then leaves slowly along the cushion multiplies the rounding
//     of the bounce. The bound holds as long as both runs meet the same events. They may differ only where two
//     events lie within that bound of each other, or a cushion is grazed that closely.
#pragma once

#include <utility>

#include "bankshot/simulate/ball_track.hpp"

namespace bankshot {

/// T is the scalar (scalar.hpp). `boundary` must outlive the simulator.
template <class T, class Motion, class Cushion>
class Simulator {
 public:
  Simulator(const Boundary& boundary, const Motion& motion, const Cushion& cushion, const State<T>& start)
      : track_(boundary, start), motion_(motion), cushion_(cushion), time_(0) {
    if constexpr (!Motion::straight) track_.settle();
  }

  /// Moves to the next event, or by `horizon` seconds if that comes first. If the law of motion hands over pieces, the
  /// last one leads to the event. `watch` sees those before, and how far they were followed.
  template <class Watch = Unwatched>
  Event step(const T& horizon = T(forever), Watch&& watch = {}) {
    if (pending_) {
      const Contact second = std::exchange(pending_, {});
      if (track_.approach(second) > Number(0)) return second_of_instant(second);
    }
    for (T left = horizon;;) {
      const Next next = track_.next(motion_, left);
      if (!(next.time < Number(forever))) {
        track_.stay();
        return {EventKind::horizon};
      }
      track_.go(motion_, track_.when(motion_, next));
      const T lasted = track_.arc().seconds(track_.travelled());
      time_ += lasted;
      if (!next.piece) return happens(next);
      watch(track_.arc(), track_.travelled());
      left -= lasted;
    }
  }

  const State<T>& state() const { return track_.state(); }    ///< right after the last event
  const State<T>& before() const { return track_.before(); }  ///< where the last arc began
  const T& time() const { return time_; }                     ///< seconds since the launch
  const Arc<T>& arc() const { return track_.arc(); }          ///< the arc that led to the last event
  const T& travelled() const { return track_.travelled(); }   ///< parameter reached on that arc, seconds on most
  const Work& work() const { return track_.work(); }          ///< since the launch
  /// Returns the state on the path along that arc, which may be its chord.
  State<T> on_arc(const T& parameter) const {
    return advance(motion_, track_.boundary().body, before(), arc(), parameter);
  }

  /// Returns the unit vector away from a contact, into the table, for the ball where it is now.
  Vec2<T> normal(Contact contact) const { return track_.boundary().normal(contact, state().at); }

  /// Goes on from another state at the same event, such as the present one with fresh derivatives.
  void resume(const State<T>& state) { track_.resume(state); }

 private:
  using Number = Real<T>;
  using Next = detail::NextEvent<Number>;

  Event happens(const Next& next) {
    if (next.event.bounces()) return first_of_instant(next);
    if (next.event.kind == EventKind::rest || next.event.kind == EventKind::slide_to_roll) track_.finish(motion_);
    return next.event;
  }

  Event first_of_instant(const Next& next) {
    Contact first = next.event.contact, second = next.second;
    if (second && track_.approach(second) > track_.approach(first)) std::swap(first, second);
    track_.meet(cushion_, first, second);
    pending_ = second;
    return {bounce_off(first), first};
  }

  Event second_of_instant(Contact contact) {
    track_.meet_also(motion_, cushion_, contact);
    if constexpr (has_derivatives<T>) time_ += track_.travelled();
    return {bounce_off(contact), contact, true};
  }

  BallTrack<T> track_;
  Motion motion_;
  Cushion cushion_;
  T time_;
  Contact pending_{};  ///< second cushion of a corner, whose bounce is still to come
};

}  // namespace bankshot
