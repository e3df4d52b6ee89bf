// SPDX-License-Identifier: MIT
//
// The forward simulator of many balls, event by event. It uses the arcs, contacts and laws of the simulator of one ball
// (simulator.hpp), whose properties hold for each ball. It keeps each ball's own next event and the next meeting of
// each pair. An event renews only those of its balls.
//  7. One instant: pockets capture before balls meet. Of meetings the one with the larger approach speed comes first,
//     then that of the lower pair, one pair at a time. Then cushions bounce, phases change, and the horizon comes last.
//     Same instant means equal computed times.
//  8. No overlap: a meeting is found as the gap falls through 0. Balls that touch and do not approach are held apart
//     (detail/pressed.hpp), anew after each event and each piece. Two balls that overlap at the start, by no more than
//     tolerance::overlap, keep their distance until they part.
//  9. Every shot ends: slow contacts persist (contact/ball_ball.hpp), and balls in persistent contact come to rest.
//
// Memory is taken once, at the start, and when more balls are in contact at once than before.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/detail/balls_in_play.hpp"
#include "bankshot/detail/lasting.hpp"
#include "bankshot/simulate/starts.hpp"

namespace bankshot {

/// An event and its ball. If two balls met, `ball` is the lower number, and the other is the contact. A standing ball
/// of a boundary is met without a bounce; the caller decides what happens then.
struct BallEvent {
  int ball = 0;
  Event event{};
};

/// T is the scalar (scalar.hpp). Boundaries must outlive the simulator.
template <class T, class Motion, class Cushion>
class ManyBalls {
 public:
  using Number = Real<T>;

  /// The first ball is launched; the others stand.
  ManyBalls(std::span<const BallStart<T>> balls, const Motion& motion, const Cushion& cushion, const BallBall& law)
      : ManyBalls(balls, motion, cushion, law, launch_of(balls)) {}

  /// Moves to the next event, or by `horizon` seconds if that comes first. The event is then `horizon`, as it is if no
  /// ball moves any more. `watch` sees each arc that ends: the ball, the time and state at which the arc began, the
  /// arc, and how far it went.
  template <class Watch = Unwatched>
  BallEvent step(const T& horizon = T(forever), Watch&& watch = {}) {
    const T end = in_.now + horizon;
    for (;;) {
      const Due due = first_due();
      if (!(due.time < never) || value(end) < due.time) {
        if (value(end) < never) in_.now = end;
        return {0, {EventKind::horizon}};
      }
      changed_.clear();
      const BallEvent happened = due.first != due.second ? meet(due, watch) : act(due.first, watch);
      renew(changed_, watch);
      if (happened.event.kind != EventKind::horizon) return happened;
    }
  }

  /// Ends the arcs of all balls where they are now. No step may follow.
  template <class Watch>
  void stop(Watch&& watch) {
    for (std::size_t i = 0; i < in_.count(); ++i) in_.bring(i, watch);
  }

  int count() const { return static_cast<int>(in_.count()); }
  const T& time() const { return in_.now; }  ///< s since the launch
  bool in_play(int ball) const { return ball_at(ball).in_play; }
  bool moves(int ball) const { return ball_at(ball).moves; }
  /// Returns the state where the ball's arc began. For the balls of the last event, that is right after it.
  const State<T>& state(int ball) const { return ball_at(ball).track.state(); }
  const Body& body(int ball) const { return in_.body(static_cast<std::size_t>(ball)); }
  /// Returns the work of all balls. Searches for meetings of two are not counted.
  Work work() const {
    Work sum{0, meetings_of_two_};
    for (const Ball& b : in_.balls) sum += b.track.work();
    return sum;
  }

  /// Returns the present state of a ball, wherever it is on its arc.
  State<T> state_now(int ball) const {
    const Ball& s = ball_at(ball);
    const Arc<T>& arc = s.track.arc();
    return advance(in_.motion, body(ball), s.track.state(), arc, arc.parameter(T(in_.now - s.began)));
  }

 private:
  using Ball = typename detail::BallsInPlay<T, Motion>::Ball;
  static constexpr double never = forever;
  /// Order of events in one instant.
  enum class Rank { pocket, meeting, bounce, phase };

  struct Due {
    Number time{never};
    Rank rank = Rank::phase;
    std::size_t first = 0, second = 0;
  };

  /// `launch` is the speed scale of the launch, √squared_scale [m/s].
  ManyBalls(std::span<const BallStart<T>> balls, const Motion& motion, const Cushion& cushion, const BallBall& law,
            const Number& launch)
      : cushion_(cushion),
        law_(law),
        in_{.motion = motion},
        lasting_(launch),
        meetings_(balls.size() * balls.size(), Number(never)),
        fresh_(balls.size(), false) {
    in_.rounding = {Number(balls.front().boundary->touch),
                    Number(law.lasts ? tolerance::still_contact : tolerance::along) * launch};
    numbers_.reserve(balls.size());
    changed_.reserve(balls.size());
    in_.balls.reserve(balls.size());
    in_.glances.resize(balls.size());
    for (const BallStart<T>& b : balls) {
      numbers_.push_back(b.number < 0 ? static_cast<int>(in_.count()) : b.number);
      changed_.push_back(in_.count());
      in_.balls.push_back({BallTrack<T>(*b.boundary, b.state, Number(launch * launch))});
      if constexpr (!Motion::straight) in_.balls.back().track.settle();
      in_.balls.back().awake = changed_.size() == 1;
    }
    renew(changed_);
  }

  const Ball& ball_at(int ball) const { return in_.balls[static_cast<std::size_t>(ball)]; }
  /// Requires `i` < `j`.
  Number& meeting(std::size_t i, std::size_t j) { return meetings_[i * in_.count() + j]; }
  const Number& meeting(std::size_t i, std::size_t j) const { return meetings_[i * in_.count() + j]; }

  /// Returns the largest √squared_scale of the balls [m/s].
  static Number launch_of(std::span<const BallStart<T>> balls) {
    using std::sqrt;
    Number launch2(0);
    for (const BallStart<T>& b : balls)
      launch2 = std::max<Number>(launch2, squared_scale(b.state, b.boundary->body.radius));
    return sqrt(launch2);
  }

  static Rank rank_of(const detail::NextEvent<Number>& next) {
    if (next.event.kind == EventKind::pocket) return Rank::pocket;
    if (next.event.kind == EventKind::ball) return Rank::meeting;
    return next.event.bounces() ? Rank::bounce : Rank::phase;
  }

  Due first_due() const {
    Due best;
    const auto consider = [&](const Due& due) {
      if (due.time < best.time || (due.time == best.time && due.rank < best.rank)) best = due;
    };
    for (std::size_t i = 0; i < in_.count(); ++i) {
      const Number& t = in_.balls[i].due;
      if (t <= best.time && t < never) consider({t, rank_of(in_.balls[i].next), i, i});
    }
    for (std::size_t i = 0; i < in_.count(); ++i) {
      if (!(earliest(i) <= best.time) || !(earliest(i) < never)) continue;
      for (std::size_t j = i + 1; j < in_.count(); ++j) {
        const Number& t = meeting(i, j);
        if (!(t <= best.time) || !(t < never)) continue;
        const Due due{t, Rank::meeting, i, j};
        if (t < best.time || best.rank != Rank::meeting)
          consider(due);
        else if (approach(due) > approach(best))
          best = due;
      }
    }
    return best;
  }

  /// Returns the earliest meeting of a ball with those of higher numbers.
  Number& earliest(std::size_t i) { return meetings_[i * in_.count() + i]; }
  const Number& earliest(std::size_t i) const { return meetings_[i * in_.count() + i]; }

  void find_earliest(std::size_t i) {
    Number& first = earliest(i);
    first = never;
    for (std::size_t j = i + 1; j < in_.count(); ++j) first = std::min<Number>(first, meeting(i, j));
  }

  /// Returns the speed at which the two that are due to meet come nearer.
  Number approach(const Due& due) const {
    const detail::Apart<Number> apart = in_.seen(due.first, due.second, due.time);
    return -dot(apart.at, apart.velocity) / norm(apart.at);
  }

  template <class Watch>
  BallEvent meet(const Due& due, Watch&& watch) {
    const std::size_t i = due.first, j = due.second;
    const bool held = law_.lasts && approach(due) <= lasting_.slowest_meeting();
    in_.now = lift_meeting(i, j, met_at(due));
    for (const std::size_t k : {i, j}) {
      in_.bring(k, watch);
      changed_.push_back(k);
    }
    if (held) return {};
    State<T> first = in_.balls[i].track.state(), second = in_.balls[j].track.state();
    law_.collide(in_.body(i), first, in_.body(j), second);
    ++meetings_of_two_;
    for (const std::size_t k : {i, j}) {
      Ball& b = in_.balls[k];
      b.track.resume(k == i ? first : second);
      b.awake = true;
      b.pending = {};
    }
    return {static_cast<int>(i), {EventKind::ball, Contact::ball(numbers_[j])}};
  }

  /// Carries out ball i's own event.
  template <class Watch>
  BallEvent act(std::size_t i, Watch&& watch) {
    Ball& s = in_.balls[i];
    changed_.push_back(i);
    const int ball = static_cast<int>(i);
    if (s.pending) {
      const Contact second = std::exchange(s.pending, {});
      s.track.meet_also(in_.motion, cushion_, second);
      return {ball, {bounce_off(second), second, true}};
    }
    const detail::NextEvent<Number> next = s.next;
    const T parameter = s.track.when(in_.motion, next);
    in_.now = s.began + s.track.arc().seconds(parameter);
    const bool pressed = s.track.arc().pressed == Press::rolls && !s.track.arc().chord;
    if (s.moves) in_.go(i, parameter, watch);
    s.began = in_.now;
    if (next.piece) {
      if (pressed) in_.slow_to_rest(s);
      return {};
    }
    switch (next.event.kind) {
      case EventKind::pocket:
        s.in_play = s.moves = false;
        break;
      case EventKind::ball:
        break;
      case EventKind::cushion:
      case EventKind::jaw:
        return bounce(i, next);
      default:
        s.track.finish(in_.motion);
        if (next.event.kind == EventKind::rest) s.moves = s.awake = false;
    }
    return {ball, next.event};
  }

  BallEvent bounce(std::size_t i, const detail::NextEvent<Number>& next) {
    Ball& s = in_.balls[i];
    Contact first = next.event.contact, second = next.second;
    if (second && s.track.approach(second) > s.track.approach(first)) std::swap(first, second);
    s.track.meet(cushion_, first, second);
    s.pending = second;
    return {static_cast<int>(i), {bounce_off(first), first}};
  }

  /// Renews the arcs, events and meetings of these balls, and of those that they pressed on or press on now.
  template <class Watch = Unwatched>
  void renew(std::vector<std::size_t>& balls, Watch&& watch = {}) {
    lasting_.let_go(in_, balls, watch);
    for (const std::size_t i : balls) {
      in_.begin(i);
      fresh_[i] = true;
    }
    for (std::size_t i = 0; i < in_.count(); ++i)
      if (fresh_[i] || in_.balls[i].moves) in_.look_at(i);
    if constexpr (!std::is_same_v<Motion, Ideal>) lasting_.hold(in_, balls, watch);
    for (const std::size_t i : balls) {
      in_.find(in_.balls[i]);
      in_.look_at(i);
      fresh_[i] = true;
    }
    for (const std::size_t i : balls) find_meetings(i);
    for (const std::size_t i : balls) fresh_[i] = false;
  }

  /// Finds the meetings of a fresh ball with all others. Those of two fresh balls are found for the lower number.
  void find_meetings(std::size_t i) {
    earliest(i) = never;
    for (std::size_t j = 0; j < i; ++j) {
      if (fresh_[j]) continue;
      Number &time = meeting(j, i), &first = earliest(j);
      const bool was_first = time == first;
      time = next_meeting(j, i);
      if (time <= first)
        first = time;
      else if (was_first)
        find_earliest(j);
    }
    for (std::size_t j = i + 1; j < in_.count(); ++j) {
      meeting(i, j) = next_meeting(i, j);
      earliest(i) = std::min<Number>(earliest(i), meeting(i, j));
    }
  }

  /// Returns the next meeting of a pair. Requires `i` < `j`, so that each pair is computed in one way.
  Number next_meeting(std::size_t i, std::size_t j) const {
    const Ball &a = in_.balls[i], &b = in_.balls[j];
    if (in_.stay_apart(i, j) || !a.in_play || !b.in_play || (!a.moves && !b.moves) || lasting_.is_held(i, j))
      return Number(never);
    const Number now = value(in_.now), limit = std::min<Number>(a.due, b.due) - now;
    const Number t = detail::first_meeting(in_.seen(i, j, now), in_.reach(i, j), limit, in_.rounding);
    return t < never ? now + t : Number(never);
  }

  Number met_at(const Due& due) const {
    if constexpr (has_chords<Motion>)
      return on_paths(due.first, due.second, due.time);
    else
      return due.time;
  }

  /// Returns when two balls meet whose arcs are chords of their paths.
  Number on_paths(std::size_t i, std::size_t j, const Number& time) const {
    const auto there = [&](std::size_t ball, const Number& when) {
      const Ball& s = in_.balls[ball];
      const State<Number> start = value(s.track.state());
      return s.moves ? advance(in_.motion, in_.body(ball), start, value(s.track.arc()), Number(when - value(s.began)))
                     : start;
    };
    const auto both = [&](const Number& when) { return std::pair(there(i, when), there(j, when)); };
    const Number last = std::min<Number>(in_.balls[i].due, in_.balls[j].due);
    return detail::time_on_path(time, value(in_.now), last, both, [&](const auto& balls) {
      const Vec2<Number> d = balls.second.at - balls.first.at, v = balls.second.velocity - balls.first.velocity;
      const Number apart = norm(d);
      return std::pair<Number, Number>(apart - in_.reach(i, j), -dot(d, v) / apart);
    });
  }

  /// Returns the instant at which two meet, with the derivatives of their arcs.
  T lift_meeting(std::size_t i, std::size_t j, const Number& time) const {
    if constexpr (!has_derivatives<T>) {
      return time;
    } else {
      const auto at = [&](const Ball& s) {
        const Arc<T>& arc = s.track.arc();
        return arc.position(arc.parameter(T(T(time) - s.began)));
      };
      const Vec2<T> d = at(in_.balls[j]) - at(in_.balls[i]);
      const T f = dot(d, d) * 0.5;
      const detail::Apart<Number> apart = in_.seen(i, j, time);
      const Number slope = dot(apart.at, apart.velocity);
      return slope == 0 ? T(time) : T(T(time) - (f - value(f)) / slope);
    }
  }

  Cushion cushion_;
  BallBall law_;
  detail::BallsInPlay<T, Motion> in_;
  detail::LastingContacts<T, Motion> lasting_;
  std::vector<Number> meetings_;  ///< s, per pair, lower number first; on the diagonal, the earliest of the row
  std::vector<std::size_t> changed_;
  std::vector<char> fresh_;  ///< per ball: its arc is new
  long meetings_of_two_ = 0;
  std::vector<int> numbers_;  ///< number of each ball, as a contact
};

}  // namespace bankshot
