// SPDX-License-Identifier: MIT
//
// One ball in motion. The caller keeps the time: the one-ball loop of simulator.hpp, or a queue of many balls. A track
// holds the state, the arc that leads on from it, and the contacts that the centre is on (on_cushions.hpp).
//
//   auto next = track.next(motion, limit);         // finds what ends the arc, and when
//   track.go(motion, track.when(motion, next));    // goes there, or less far if something else happens first
//   track.meet(cushion, next.event.contact);       // bounces, if the ball meets a cushion
//
// Properties are numbered as in simulator.hpp. No allocation. Laws get the ball's body from the boundary.
#pragma once

#include "bankshot/detail/bounce.hpp"
#include "bankshot/detail/next_event.hpp"
#include "bankshot/detail/on_path.hpp"
#include "bankshot/detail/pressed.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "bankshot/simulate/work.hpp"

namespace bankshot {

template <class T>
class BallTrack {
 public:
  using Number = Real<T>;

  /// `boundary` must outlive the track.
  BallTrack(const Boundary& boundary, const State<T>& start)
      : BallTrack(boundary, start, squared_scale(start, boundary.body.radius)) {}
  /// `launch2` is the squared_scale of the launch, which may be that of another ball.
  BallTrack(const Boundary& boundary, const State<T>& start, const Number& launch2)
      : boundary_(&boundary), state_(start), before_(start), arc_{start.at, start.velocity}, cushions_(launch2) {}

  /// Puts a ball that starts against a cushion exactly on its line.
  void settle() { cushions_.settle_at_start(*boundary_, state_.at); }

  /// Makes the arc from the present state.
  template <class Motion>
  void begin(const Motion& motion) {
    set_out(motion);
    if constexpr (!Motion::straight) cushions_.hold(*boundary_, arc_);
    if constexpr (has_chords<Motion>)
      if (cushions_.any_holds()) hold_on_cushion(motion);
  }

  /// Finds what ends the arc within `limit` seconds. The result's time is the arc's parameter. `straight`: the arc does
  /// not bend.
  template <bool straight>
  detail::NextEvent<Number> find(const T& limit) {
    limit_ = arc_.parameter(limit);
    return detail::EventFinder<straight, Number>{*boundary_, cushions_, value(arc_)}.next(value(limit_));
  }

  template <class Motion>
  detail::NextEvent<Number> next(const Motion& motion, const T& limit) {
    begin(motion);
    return find<Motion::straight>(limit);
  }

  /// Returns the time of what `next` found, with its derivatives.
  template <class Motion>
  T when(const Motion& motion, const detail::NextEvent<Number>& next) const {
    if constexpr (has_chords<Motion>)
      if (arc_.chord && next.event.contact && next.time != Number(0))
        return detail::lift_on_path(motion, *boundary_, state_, arc_, next.event.contact,
                                    cushions_.on(next.event.contact), false, next.time);
    return detail::lift_event(*boundary_, next, arc_, cushions_.on(next.event.contact), limit_);
  }

  /// Moves the ball along the arc.
  template <class Motion>
  void go(const Motion& motion, const T& parameter) {
    travelled_ = parameter;
    state_ = advance(motion, boundary_->body, before_, arc_, travelled_);
    if (value(travelled_) > Number(0)) cushions_.leave();
  }

  /// Makes the state exact where the arc ends by itself.
  template <class Motion>
  void finish(const Motion& motion) {
    motion.finish(boundary_->body, state_, arc_);
  }

  /// Bounces off a contact. `also` is another one that the centre is on in this instant.
  template <class Cushion>
  void meet(const Cushion& cushion, Contact contact, Contact also = {}) {
    cushions_.leave();
    if (also) cushions_.meet(also);
    bounce(cushion, contact);
  }

  /// Bounces off the other contact. No time passes, but the instant of the second bounce has derivatives of its own. It
  /// is rare and therefore out of line, so that the common bounce is short enough to be inlined.
  template <class Motion, class Cushion>
  [[gnu::noinline]] void meet_also(const Motion& motion, const Cushion& cushion, Contact contact) {
    set_out(motion);
    travelled_ = T(0);
    if (const Wall* const w = boundary_->line(contact); has_derivatives<T> && w) {
      travelled_ = detail::lift_line(arc_, w->normal, w->offset, false, Number(0));
      state_ = advance(motion, boundary_->body, before_, arc_, travelled_);
    }
    bounce(cushion, contact);
  }

  /// Lets time pass for a ball that stands. Only its vertical spin fades.
  template <class Motion>
  void wait(const Motion& motion, const T& seconds) {
    if (value(state_.spin.z) != Number(0)) motion.turn(boundary_->body, state_, arc_, seconds);
  }

  /// Adds a little velocity. A ball that rolls goes on rolling.
  template <class Motion>
  void nudge(const Motion& motion, const Vec2<T>& velocity) {
    const bool rolls = !detail::slides(arc_);
    state_.velocity += velocity;
    if (rolls) motion.roll(boundary_->body, state_);
  }

  /// Adds the acceleration that others give the centre all along the arc.
  void press(const Vec2<T>& push, const Number& longest) {
    detail::press(arc_, push, longest);
    cushions_.let_go(*boundary_, value(state_.at), value(push));
  }
  /// Keeps the ball at this cushion, which the centre is on, all along the arc.
  void hold(Contact contact) { cushions_.hold(contact); }
  /// Returns the cushion, tip or facing that the centre is exactly on. There may be none, one or two.
  Contact on(int k) const { return cushions_.at(k); }

  /// Returns the speed towards a contact.
  Number approach(Contact contact) const {
    return -dot(boundary_->normal(contact, value(state_.at)), value(state_.velocity));
  }

  const Boundary& boundary() const { return *boundary_; }
  const State<T>& state() const { return state_; }    ///< present state
  const State<T>& before() const { return before_; }  ///< state at the start of its arc
  const Arc<T>& arc() const { return arc_; }
  const T& travelled() const { return travelled_; }  ///< parameter reached on that arc
  const Work& work() const { return work_; }

  /// Leaves the ball where it is.
  void stay() { travelled_ = T(0); }
  /// Goes on from another state at the same place, such as the present one with fresh derivatives.
  void resume(const State<T>& state) { state_ = state; }

 private:
  template <class Motion>
  void set_out(const Motion& motion) {
    before_ = state_;
    arc_ = motion.arc(boundary_->body, state_);
    ++work_.arcs;
  }

  template <class Motion>
  void hold_on_cushion(const Motion& motion) {
    const Contact first = cushions_.at(0), second = cushions_.at(1);
    const bool by_first = first && cushions_.held(first), by_second = second && cushions_.held(second);
    State<T> there = state_;
    there.velocity = arc_.velocity;
    arc_ = motion.held(boundary_->body, there, boundary_->normal(by_first ? first : second, value(state_.at)),
                       by_first && by_second);
  }

  // Inlined, because calls would take a tenth of a shot whose paths are straight.
  template <class Cushion>
  [[gnu::always_inline]] void bounce(const Cushion& cushion, Contact contact) {
    const Body& body = boundary_->body;
    cushions_.settle(*boundary_, contact, state_.at);
    cushions_.bounces(squared_scale(state_, body.radius));
    detail::bounce_at(*boundary_, cushion, contact, state_);
    ++work_.impacts;
    const Vec2<Number> v = value(state_.velocity);
    if (cushions_.is_rounding(dot(v, v))) state_.velocity = {T(0), T(0)};
    if (cushions_.is_still(squared_scale(state_, body.radius))) {
      state_.velocity = {T(0), T(0)};
      state_.spin.x = state_.spin.y = T(0);
    }
  }

  const Boundary* boundary_;
  State<T> state_;
  State<T> before_;
  Arc<T> arc_;
  T limit_{0};  ///< limit of the arc's parameter
  T travelled_{0};
  Work work_{};
  detail::OnCushions<Number> cushions_;
};

}  // namespace bankshot
