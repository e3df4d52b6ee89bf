// SPDX-License-Identifier: MIT
//
// One ball on its way, whoever keeps the time: the one-ball loop of simulator.hpp, or a queue of many balls. It
// holds the state, the arc that leads on from it, and the contacts that the centre is on (on_cushions.hpp).
//
//   auto next = track.next(motion, limit);     // what ends its arc, and when
//   track.go(motion, track.when(next));        // there, or less far when something else happens first
//   track.meet(cushion, next.event.contact);   // where it meets something
//
// Properties as numbered in simulator.hpp. No allocation; laws are told the ball's body, which is the boundary's.
#pragma once

#include "bankshot/detail/bounce.hpp"
#include "bankshot/detail/next_event.hpp"
#include "bankshot/detail/on_path.hpp"
#include "bankshot/detail/pressed.hpp"

namespace bankshot {

template <class T>
class BallTrack {
 public:
  using Number = Real<T>;

  /// `boundary` must outlive it.
  BallTrack(const Boundary& boundary, const State<T>& start)
      : BallTrack(boundary, start, squared_scale(start, boundary.body.radius)) {}
  /// `launch2`: squared_scale of the launch, where another ball is struck.
  BallTrack(const Boundary& boundary, const State<T>& start, const Number& launch2)
      : boundary_(&boundary), state_(start), before_(start), arc_{start.at, start.velocity}, cushions_(launch2) {}

  /// A ball that starts against a cushion is put exactly on its line.
  void settle() { cushions_.settle_at_start(*boundary_, state_.at); }

  /// Makes the arc from here.
  template <class Motion>
  void begin(const Motion& motion) {
    set_out(motion);
    if constexpr (!Motion::straight) cushions_.hold(*boundary_, arc_);
    if constexpr (has_chords<Motion>)
      if (cushions_.any_holds()) hold_on_cushion(motion);
  }

  /// What ends the arc within `limit` seconds; its time is the arc's parameter. `straight`: the arc does not bend.
  template <bool straight>
  NextEvent<Number> find(const T& limit) {
    limit_ = arc_.parameter(limit);
    return EventFinder<straight, Number>{*boundary_, cushions_, value(arc_)}.next(value(limit_));
  }

  template <class Motion>
  NextEvent<Number> next(const Motion& motion, const T& limit) {
    begin(motion);
    return find<Motion::straight>(limit);
  }

  /// The time of what `next` told, with its derivatives.
  template <class Motion>
  T when(const Motion& motion, const NextEvent<Number>& next) const {
    if constexpr (has_chords<Motion>)
      if (arc_.chord && next.event.contact && next.time != Number(0))
        return lift_on_path(motion, *boundary_, state_, arc_, next.event.contact, cushions_.on(next.event.contact),
                            false, next.time);
    return lift_event(*boundary_, next, arc_, cushions_.on(next.event.contact), limit_);
  }

  /// Along the arc.
  template <class Motion>
  void go(const Motion& motion, const T& parameter) {
    travelled_ = parameter;
    state_ = advance(motion, boundary_->body, before_, arc_, travelled_);
    if (value(travelled_) > Number(0)) cushions_.leave();
  }

  /// Where the arc ends by itself, the state becomes exact.
  template <class Motion>
  void finish(const Motion& motion) {
    motion.finish(boundary_->body, state_, arc_);
  }

  /// Bounces off a contact. `also`: another one that the centre is on in this instant.
  template <class Cushion>
  void meet(const Cushion& cushion, Contact contact, Contact also = {}) {
    cushions_.leave();
    if (also) cushions_.meet(also);
    bounce(cushion, contact);
  }

  /// Bounces off the other one. No time passes, but the instant of the second bounce has derivatives of its own.
  /// Rare, so out of line: the common bounce is short enough to be inlined then.
  template <class Motion, class Cushion>
  [[gnu::noinline]] void meet_also(const Motion& motion, const Cushion& cushion, Contact contact) {
    set_out(motion);
    travelled_ = T(0);
    if (const Wall* const w = boundary_->line(contact); has_derivatives<T> && w) {
      travelled_ = lift_line(arc_, w->normal, w->offset, false, Number(0));
      state_ = advance(motion, boundary_->body, before_, arc_, travelled_);
    }
    bounce(cushion, contact);
  }

  /// Time passes for a ball that stands: only its vertical spin fades.
  template <class Motion>
  void wait(const Motion& motion, const T& seconds) {
    if (value(state_.spin.z) != Number(0)) motion.turn(boundary_->body, state_, arc_, seconds);
  }

  /// A little more velocity; where it rolls, it goes on rolling.
  template <class Motion>
  void nudge(const Motion& motion, const Vec2<T>& velocity) {
    const bool rolls = !slides(arc_);
    state_.velocity += velocity;
    if (rolls) motion.roll(boundary_->body, state_);
  }

  /// Others push its centre with this acceleration all along the arc.
  void press(const Vec2<T>& push, const Number& longest) {
    bankshot::press(arc_, push, longest);
    cushions_.let_go(*boundary_, value(state_.at), value(push));
  }
  /// It stays at this cushion, which the centre is on, all along the arc.
  void hold(Contact contact) { cushions_.hold(contact); }
  /// The cushion, tip or facing that the centre is exactly on: none, one or two.
  Contact on(int k) const { return cushions_.at(k); }

  /// Speed towards a contact.
  Number approach(Contact contact) const {
    return -dot(boundary_->normal(contact, value(state_.at)), value(state_.velocity));
  }

  const Boundary& boundary() const { return *boundary_; }
  const State<T>& state() const { return state_; }    ///< where it is
  const State<T>& before() const { return before_; }  ///< where its arc began
  const Arc<T>& arc() const { return arc_; }
  const T& travelled() const { return travelled_; }  ///< how far on that arc: its parameter

  /// It does not go on from here.
  void stay() { travelled_ = T(0); }
  /// Goes on from another state at the same place, such as the same with fresh derivatives.
  void resume(const State<T>& state) { state_ = state; }

 private:
  template <class Motion>
  void set_out(const Motion& motion) {
    before_ = state_;
    arc_ = motion.arc(boundary_->body, state_);
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

  // A call takes a tenth of a shot whose paths are straight.
  template <class Cushion>
  [[gnu::always_inline]] void bounce(const Cushion& cushion, Contact contact) {
    const Body& body = boundary_->body;
    cushions_.settle(*boundary_, contact, state_.at);
    cushions_.bounces(squared_scale(state_, body.radius));
    bounce_at(*boundary_, cushion, contact, state_);
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
  T limit_{0};  ///< of the arc's parameter
  T travelled_{0};
  OnCushions<Number> cushions_;
};

}  // namespace bankshot
