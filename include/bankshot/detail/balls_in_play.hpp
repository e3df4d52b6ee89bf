// SPDX-License-Identifier: MIT
//
// The balls on a table, each on its own arc, and the clock that they share. The owner of this state decides what
// happens next (simulate/many_balls.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bankshot/detail/roots/meeting.hpp"
#include "bankshot/simulate/ball_track.hpp"

namespace bankshot::detail {

template <class T, class Motion>
struct BallsInPlay {
  using Number = Real<T>;
  static constexpr double never = forever;

  struct Ball {
    BallTrack<T> track;
    T began{0};                ///< s, start of its arc
    NextEvent<Number> next{};  ///< next event of the ball alone
    Number due{never};         ///< s, time of that event
    Number fastest{0};         ///< m/s, highest speed on its arc
    Number bend{0};            ///< m/s², bound on the acceleration on its arc
    Contact pending{};         ///< second cushion of a corner, whose bounce is still to come
    bool in_play = true;
    bool moves = false;
    bool awake = false;  ///< it was hit, and is not known to rest
  };

  /// Data of the broad phase, side by side in memory: where a ball is now and how it goes on.
  struct Glance {
    Vec2<Number> at{}, velocity{};
    Number fastest{0}, bend{0}, due{never};
    double radius{0};  ///< m
  };

  std::vector<Ball> balls{};
  std::vector<Glance> glances{};
  Motion motion;
  Rounding<Number> rounding{};
  T now{0};  ///< s since the launch

  std::size_t count() const { return balls.size(); }
  const Body& body(std::size_t i) const { return balls[i].track.boundary().body; }

  /// Returns the motion of the second ball as seen from the first, at `time`, on the arcs that they are on.
  Apart<Number> seen(std::size_t i, std::size_t j, const Number& time) const {
    const Ball &a = balls[i], &b = balls[j];
    return {value(a.track.arc()), Number(time - value(a.began)), value(b.track.arc()), Number(time - value(b.began))};
  }

  /// Returns the distance of their centres when they touch [m].
  Number reach(std::size_t i, std::size_t j) const { return Number(touching_distance(body(i), body(j))); }

  /// Moves a ball along its arc to the present time.
  template <class Watch>
  void bring(std::size_t i, Watch&& watch) {
    Ball& s = balls[i];
    const T lasted = now - s.began;
    if (s.moves)
      go(i, s.track.arc().parameter(lasted), watch);
    else if (s.in_play && value(lasted) > Number(0))
      s.track.wait(motion, lasted);
    s.began = now;
  }

  template <class Watch>
  void go(std::size_t i, const T& parameter, Watch&& watch) {
    Ball& s = balls[i];
    s.track.go(motion, parameter);
    watch(static_cast<int>(i), s.began, s.track.before(), s.track.arc(), parameter);
  }

  /// Makes a new arc from where the ball is.
  void begin(std::size_t i) {
    Ball& s = balls[i];
    if (s.in_play) s.track.begin(motion);
  }

  /// Returns true if a ball does not move on this arc.
  static bool stands(const Arc<Number>& arc) { return arc.end == PhaseEnd::rest && !(arc.duration > Number(0)); }

  /// Finds when the ball's own next event comes, if it moves.
  void find(Ball& s) {
    s.due = never;
    s.moves = false;
    s.fastest = s.bend = Number(0);
    if (!s.in_play) return;
    const Arc<Number>& arc = value(s.track.arc());
    if (stands(arc) && !s.awake) return;
    s.awake = s.moves = true;
    if (s.pending && s.track.approach(s.pending) > Number(0)) {
      s.next.set(Number(0), bounce_off(s.pending), s.pending);
      s.due = value(now);
      return;
    }
    s.pending = {};
    s.next = s.track.template find<false>(T(never));  // in persistent contact, a path bends in any motion model
    const Number lasts = arc.seconds(s.next.time);
    if (lasts < never) s.due = value(s.began) + lasts;
    s.fastest = fastest_on(arc, s.next.time);
    s.bend = most_bend(arc);
  }

  /// Returns the highest speed up to a parameter [m/s]. It is reached at one of the two ends.
  static Number fastest_on(const Arc<Number>& arc, const Number& until) {
    using std::sqrt;
    const Number begin2 = dot(arc.velocity, arc.velocity);
    if (!arc.bends || !(until < never)) return sqrt(begin2);
    const Vec2<Number> end = arc.tangent(until);
    return sqrt(std::max<Number>(begin2, dot(end, end)));
  }

  /// Updates the glance of a ball from its arc at the present time.
  void look_at(std::size_t i) {
    const Ball& s = balls[i];
    const Arc<Number>& arc = value(s.track.arc());
    const Number t = arc.parameter(Number(value(now) - value(s.began)));
    glances[i] = {arc.position(t), arc.velocity_at(t), s.fastest, s.bend, s.due, body(i).radius};
  }

  /// Returns true if two balls with current glances are too far from each other to touch now.
  bool are_apart(std::size_t i, std::size_t j) const {
    const Glance &a = glances[i], &b = glances[j];
    const Vec2<Number> d = b.at - a.at;
    const Number near = Number(touching_distance(a.radius, b.radius)) + 3 * rounding.touch;
    return dot(d, d) > near * near;
  }

  /// Returns true if two balls with current glances cannot touch before one of them is due. Either of two bounds shows
  /// it: their highest speeds, or their present motion.
  bool stay_apart(std::size_t i, std::size_t j) const {
    const Glance &a = glances[i], &b = glances[j];
    const Vec2<Number> d = b.at - a.at;
    const Number reach(touching_distance(a.radius, b.radius)), limit = std::min<Number>(a.due, b.due) - value(now);
    const Number near = reach + 2 * rounding.touch + (a.fastest + b.fastest) * limit;
    if (dot(d, d) > near * near) return true;
    return cannot_meet(d, Vec2<Number>(b.velocity - a.velocity), Number(a.bend + b.bend), reach, limit, rounding);
  }

  /// Returns true if a ball in persistent contact is so slow that it counts as resting.
  static bool hardly_moves(const Vec2<T>& velocity) {
    constexpr double slow = tolerance::slow_contact * tolerance::pressed_rest;
    return dot(value(velocity), value(velocity)) < Number(slow * slow);
  }

  /// Brings a rolling ball to rest if it hardly moves at the end of a persistent contact.
  void slow_to_rest(Ball& s) {
    State<T> state = s.track.state();
    if (!hardly_moves(state.velocity)) return;
    state.velocity = {T(0), T(0)};
    state.spin.x = state.spin.y = T(0);
    s.track.resume(state);
  }
};

}  // namespace bankshot::detail
