// SPDX-License-Identifier: MIT
//
// The forward simulator of many balls, event by event, over the same arcs, contacts and laws as that of one
// (simulator.hpp), whose properties hold for each ball. A ball's own next event and the next meeting of each pair are
// kept; an event renews those of its balls alone.
//   7. One instant: pockets capture before balls meet; of those the larger approach speed first, then the lower pair,
//      one pair at a time; then cushions bounce, phases change, and the horizon comes last. Same instant means equal
//      computed times.
//   8. No overlap: a meeting is found as the gap falls through 0, and balls that touch and do not approach are held
//      apart (detail/pressed.hpp), anew after each event and each piece. Two that overlap at the start by no more than
//      tolerance::overlap keep the distance they have until they part.
//   9. Every shot ends: slow contacts last (contact/ball_ball.hpp), pressed balls come to rest.
// Memory is taken once, at the start, and where more balls are pressed at once than before.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/detail/roots/meeting.hpp"
#include "bankshot/simulate/ball_track.hpp"
#include "bankshot/simulate/starts.hpp"

namespace bankshot {

/// Of two balls that met the first is `ball`, the lower number, and the other the contact.
struct BallEvent {
  int ball = 0;
  Event event{};
};

/// T: the scalar (scalar.hpp). Boundaries must outlive it.
template <class T, class Motion, class Cushion>
class ManyBalls {
 public:
  using Number = Real<T>;

  /// Ball 0 is struck, the others stand.
  ManyBalls(std::span<const BallStart<T>> balls, const Motion& motion, const Cushion& cushion, const BallBall& law)
      : motion_(motion), cushion_(cushion), law_(law), count_(balls.size()), meetings_(count_ * count_, Number(never)) {
    using std::sqrt;
    Number launch2(0);
    for (const BallStart<T>& b : balls)
      launch2 = std::max<Number>(launch2, squared_scale(b.state, b.boundary->body.radius));
    const Number launch = sqrt(launch2);
    rounding_ = {Number(balls.front().boundary->touch),
                 Number(law.lasts ? tolerance::still_contact : tolerance::along) * launch};
    held_speed_ = std::min<Number>(Number(tolerance::held_contact), Number(tolerance::held_part) * launch);
    slots_.reserve(count_);
    for (const BallStart<T>& b : balls) {
      slots_.push_back({BallTrack<T>(*b.boundary, b.state, launch2)});
      if constexpr (!Motion::straight) slots_.back().track.settle();
      slots_.back().awake = dot(value(b.state.velocity), value(b.state.velocity)) > Number(0) || &b == &balls.front();
    }
    for (std::size_t i = 0; i < count_; ++i) changed_.push_back(i);
    renew(changed_);
  }

  /// Moves to the next event, or `horizon` seconds on if that comes first: then its kind is `horizon`, as where no ball
  /// moves any more. `watch` is shown each arc that ends: the ball, when it began and how, the arc, how far it went.
  template <class Watch>
  BallEvent step(const T& horizon, Watch&& watch) {
    const T end = now_ + horizon;
    for (;;) {
      const Due due = first_due();
      if (!(due.time < never) || value(end) < due.time) {
        if (value(end) < never) now_ = end;
        return {0, {EventKind::horizon}};
      }
      changed_.clear();
      const BallEvent happened = due.rank == Rank::meeting ? meet(due, watch) : act(due.first, watch);
      renew(changed_, watch);
      if (happened.event.kind != EventKind::horizon) return happened;
    }
  }

  /// Ends the arcs of all balls where they are now; there is no step after it.
  template <class Watch>
  void stop(Watch&& watch) {
    for (std::size_t i = 0; i < count_; ++i) bring(i, watch);
  }

  int count() const { return static_cast<int>(count_); }
  const T& time() const { return now_; }  ///< s since the launch
  bool in_play(int ball) const { return slot(ball).in_play; }
  bool moves(int ball) const { return slot(ball).moves; }
  /// Where the ball's arc began: of the balls of the last event, right after it.
  const State<T>& state(int ball) const { return slot(ball).track.state(); }
  const Body& body(int ball) const { return slot(ball).track.boundary().body; }

  /// Where the ball is now, wherever on its arc.
  State<T> state_now(int ball) const {
    const Slot& s = slot(ball);
    const Arc<T>& arc = s.track.arc();
    return advance(motion_, body(ball), s.track.state(), arc, arc.parameter(T(now_ - s.began)));
  }

 private:
  static constexpr double never = forever;
  /// What comes first in one instant.
  enum class Rank { pocket, meeting, bounce, phase };

  struct Slot {
    BallTrack<T> track;
    T began{0};                ///< s, its arc
    NextEvent<Number> next{};  ///< of the ball alone
    Number due{never};         ///< s, that
    Number fastest{0};         ///< m/s, on its arc at most
    Contact pending{};         ///< the second cushion of a corner, still to bounce
    bool in_play = true;
    bool moves = false;
    bool awake = false;  ///< it was struck, and is not known to rest
  };

  struct Due {
    Number time{never};
    Rank rank = Rank::phase;
    std::size_t first = 0, second = 0;
    Number approach{0};
  };

  const Slot& slot(int ball) const { return slots_[static_cast<std::size_t>(ball)]; }
  Number& meeting(std::size_t i, std::size_t j) { return meetings_[std::min(i, j) * count_ + std::max(i, j)]; }
  const Number& meeting(std::size_t i, std::size_t j) const { return meetings_[i * count_ + j]; }

  using Two = std::pair<std::size_t, std::size_t>;
  static Two in_order(std::size_t i, std::size_t j) { return i < j ? Two{i, j} : Two{j, i}; }

  static Rank rank_of(const NextEvent<Number>& next) {
    if (next.event.kind == EventKind::pocket) return Rank::pocket;
    return next.event.bounces() ? Rank::bounce : Rank::phase;
  }

  Due first_due() const {
    Due best;
    const auto consider = [&](const Due& due) {
      if (due.time < best.time || (due.time == best.time && due.time < never && due.rank < best.rank)) best = due;
    };
    for (std::size_t i = 0; i < count_; ++i) consider({slots_[i].due, rank_of(slots_[i].next), i, i});
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        const Number& t = meeting(i, j);
        if (!(t <= best.time) || !(t < never)) continue;
        Due due{t, Rank::meeting, i, j};
        if (t < best.time || best.rank != Rank::meeting) {
          consider(due);
          continue;
        }
        due.approach = approach(due);
        if (due.approach > approach(best)) best = due;
      }
    return best;
  }

  static Number approach(const State<T>& first, const State<T>& second) {
    const Vec2<Number> d = value(second.at) - value(first.at);
    return dot(d, Vec2<Number>(value(first.velocity) - value(second.velocity))) / norm(d);
  }

  /// Speed at which the two that are due to meet come nearer.
  Number approach(const Due& due) const {
    const Apart<Number> apart = seen(due.first, due.second, due.time);
    return -dot(apart.at, apart.velocity) / norm(apart.at);
  }

  Apart<Number> seen(std::size_t i, std::size_t j, const Number& time) const {
    const Slot &a = slots_[i], &b = slots_[j];
    return {value(a.track.arc()), Number(time - value(a.began)), value(b.track.arc()), Number(time - value(b.began))};
  }

  Number reach(std::size_t i, std::size_t j) const {
    return Number(slots_[i].track.boundary().body.radius) + Number(slots_[j].track.boundary().body.radius);
  }

  /// Along its arc, to now.
  template <class Watch>
  void bring(std::size_t i, Watch&& watch) {
    Slot& s = slots_[i];
    const T lasted = now_ - s.began;
    if (s.moves)
      go(i, s.track.arc().parameter(lasted), watch);
    else if (s.in_play && value(lasted) > Number(0))
      s.track.wait(motion_, lasted);
    s.began = now_;
  }

  template <class Watch>
  void go(std::size_t i, const T& parameter, Watch&& watch) {
    Slot& s = slots_[i];
    s.track.go(motion_, parameter);
    watch(static_cast<int>(i), s.began, s.track.before(), s.track.arc(), parameter);
  }

  template <class Watch>
  BallEvent meet(const Due& due, Watch&& watch) {
    const std::size_t i = due.first, j = due.second;
    now_ = lift_meeting(i, j, due.time);
    for (const std::size_t k : {i, j}) {
      bring(k, watch);
      slots_[k].awake = true;
      slots_[k].pending = {};
      changed_.push_back(k);
    }
    State<T> first = slots_[i].track.state(), second = slots_[j].track.state();
    if (law_.lasts && approach(first, second) <= held_speed_) return {};
    law_.collide(slots_[i].track.boundary().body, first, slots_[j].track.boundary().body, second);
    slots_[i].track.resume(first);
    slots_[j].track.resume(second);
    return {static_cast<int>(i), {EventKind::ball, Contact::ball(static_cast<int>(j))}};
  }

  /// What ball i does by itself.
  template <class Watch>
  BallEvent act(std::size_t i, Watch&& watch) {
    Slot& s = slots_[i];
    changed_.push_back(i);
    const int ball = static_cast<int>(i);
    if (s.pending) {
      const Contact second = std::exchange(s.pending, {});
      s.track.meet_also(motion_, cushion_, second);
      return {ball, {bounce_off(second), second, true}};
    }
    const NextEvent<Number> next = s.next;
    const T parameter = s.track.when(next);
    now_ = s.began + s.track.arc().seconds(parameter);
    const bool pressed = s.track.arc().pressed == Press::rolls;
    if (s.moves) go(i, parameter, watch);
    s.began = now_;
    if (next.piece) {
      if (pressed) slow_to_rest(s);
      return {};
    }
    switch (next.event.kind) {
      case EventKind::pocket:
        s.in_play = s.moves = false;
        break;
      case EventKind::cushion:
      case EventKind::jaw:
        return bounce(i, next);
      default:
        s.track.finish(motion_);
        if (next.event.kind == EventKind::rest) s.moves = s.awake = false;
    }
    return {ball, next.event};
  }

  BallEvent bounce(std::size_t i, const NextEvent<Number>& next) {
    Slot& s = slots_[i];
    Contact first = next.event.contact, second = next.second;
    if (second && s.track.approach(second) > s.track.approach(first)) std::swap(first, second);
    s.track.meet(cushion_, first, second);
    s.pending = second;
    return {static_cast<int>(i), {bounce_off(first), first}};
  }

  void slow_to_rest(Slot& s) {
    constexpr double slow = tolerance::slow_contact * tolerance::pressed_rest;
    State<T> state = s.track.state();
    if (!(dot(value(state.velocity), value(state.velocity)) < Number(slow * slow))) return;
    state.velocity = {T(0), T(0)};
    state.spin.x = state.spin.y = T(0);
    s.track.resume(state);
  }

  struct Unseen {
    void operator()(int, const T&, const State<T>&, const Arc<T>&, const T&) const {}
  };

  /// New arcs, events and meetings of these balls, and of those that they pressed on or press on now.
  template <class Watch = Unseen>
  void renew(std::vector<std::size_t>& balls, Watch&& watch = {}) {
    let_go(balls, watch);
    for (const std::size_t i : balls) begin(i);
    if constexpr (!std::is_same_v<Motion, Ideal>) hold(balls, watch);
    for (const std::size_t i : balls) find(slots_[i]);
    for (const std::size_t i : balls)
      for (std::size_t j = 0; j < count_; ++j)
        if (j != i && !(j < i && std::find(balls.begin(), balls.end(), j) != balls.end())) find_meeting(i, j);
  }

  void begin(std::size_t i) {
    Slot& s = slots_[i];
    if (s.in_play) s.track.begin(motion_);
  }

  /// When the ball's own next event comes, if it moves.
  void find(Slot& s) {
    s.due = never;
    s.moves = false;
    s.fastest = Number(0);
    if (!s.in_play) return;
    const Arc<Number>& arc = value(s.track.arc());
    const bool stands = arc.end == PhaseEnd::rest && !(arc.duration > Number(0));
    if (stands && !s.awake) return;
    s.awake = s.moves = true;
    if (s.pending && s.track.approach(s.pending) > Number(0)) {
      s.next.set(Number(0), bounce_off(s.pending), s.pending);
      s.due = value(now_);
      return;
    }
    s.pending = {};
    s.next = s.track.template find<false>(T(never));  // a ball that is pressed bends in any motion
    const Number lasts = arc.seconds(s.next.time);
    if (lasts < never) s.due = value(s.began) + lasts;
    s.fastest = fastest_on(arc, s.next.time);
  }

  /// m/s, up to a parameter: at one of its ends.
  static Number fastest_on(const Arc<Number>& arc, const Number& until) {
    using std::sqrt;
    const Number begin2 = dot(arc.velocity, arc.velocity);
    if (!arc.bends || !(until < never)) return sqrt(begin2);
    const Vec2<Number> end = arc.tangent(until);
    return sqrt(std::max<Number>(begin2, dot(end, end)));
  }

  /// Two are too far from each other to touch within so many seconds from now, on the arcs that they are on.
  bool too_far(std::size_t i, std::size_t j, const Number& seconds) const {
    const Slot &a = slots_[i], &b = slots_[j];
    const auto way = [&](const Slot& s) { return s.fastest * (value(now_) - value(s.began) + seconds); };
    const Vec2<Number> d = value(b.track.state().at) - value(a.track.state().at);
    const Number near = reach(i, j) + rounding_.touch + way(a) + way(b);
    return dot(d, d) > near * near;
  }

  void find_meeting(std::size_t i, std::size_t j) {
    Number& time = meeting(i, j);
    time = never;
    const Slot &a = slots_[i], &b = slots_[j];
    if (!a.in_play || !b.in_play || (!a.moves && !b.moves)) return;
    const Number now = value(now_), limit = std::min<Number>(a.due, b.due) - now;
    if (too_far(i, j, limit) || is_held(i, j)) return;
    // The lower number is the first, so that a pair is looked at in one way.
    const auto [low, high] = in_order(i, j);
    const Number t = first_meeting(seen(low, high, now), reach(i, j), Number(limit), rounding_);
    if (t < never) time = now + t;
  }

  /// The instant at which two meet, with the derivatives of their arcs.
  T lift_meeting(std::size_t i, std::size_t j, const Number& time) const {
    if constexpr (!has_derivatives<T>) {
      return time;
    } else {
      const auto at = [&](const Slot& s) {
        const Arc<T>& arc = s.track.arc();
        return arc.position(arc.parameter(T(T(time) - s.began)));
      };
      const Vec2<T> d = at(slots_[j]) - at(slots_[i]);
      const T f = dot(d, d) * 0.5;
      const Apart<Number> apart = seen(i, j, time);
      const Number slope = dot(apart.at, apart.velocity);
      return slope == 0 ? T(time) : T(T(time) - (f - value(f)) / slope);
    }
  }

  // Lasting contacts.

  /// Two balls touch and neither approach nor part, to speak of. If so `driven` says whether they do approach, or will.
  bool touch(std::size_t i, std::size_t j, bool& driven) const {
    using std::abs;
    if (!slots_[i].in_play || !slots_[j].in_play || too_far(i, j, Number(0))) return false;
    const Apart<Number> apart = seen(i, j, value(now_));
    const Number near = reach(i, j) + rounding_.touch, far2 = dot(apart.at, apart.at);
    if (!(far2 < near * near)) return false;
    const Vec2<Number> normal = apart.at / norm(apart.at);
    const Number parting = dot(normal, apart.velocity);
    driven = parting < -rounding_.still || dot(normal, Vec2<Number>(value(pull(j)) - value(pull(i)))) < Number(0);
    return abs(parting) <= held_speed_;
  }

  /// Its acceleration without those of other balls.
  Vec2<T> pull(std::size_t i) const {
    const Arc<T>& arc = slots_[i].track.arc();
    if (arc.end == PhaseEnd::rest && !(value(arc.duration) > Number(0))) return {T(0), T(0)};
    return first_acceleration(arc);
  }

  bool is_held(std::size_t i, std::size_t j) const {
    return std::ranges::any_of(held_, [&](const auto& pair) { return pair == in_order(i, j); });
  }

  /// Forces between these balls and others end here; the others join them.
  template <class Watch>
  void let_go(std::vector<std::size_t>& balls, Watch&& watch) {
    for (std::size_t k = 0; k < balls.size() && !held_.empty(); ++k) {
      const auto [these, rest] = std::ranges::partition(
          held_, [&](const Two& pair) { return pair.first != balls[k] && pair.second != balls[k]; });
      for (auto pair = these; pair != rest; ++pair) {
        const std::size_t other = pair->first == balls[k] ? pair->second : pair->first;
        if (std::find(balls.begin(), balls.end(), other) != balls.end()) continue;
        const bool rolls = slots_[other].track.arc().pressed == Press::rolls;
        bring(other, watch);
        if (rolls) slow_to_rest(slots_[other]);
        balls.push_back(other);
      }
      held_.erase(these, rest);
    }
  }

  /// Of balls whose arcs have just begun: those that friction drives into another are held apart from it. Joins to
  /// `balls` whoever they touch.
  template <class Watch>
  void hold(std::vector<std::size_t>& balls, Watch&& watch) {
    bool driven = false, any = false;
    for (std::size_t k = 0; k < balls.size() && !any; ++k)
      for (std::size_t j = 0; j < count_ && !any; ++j) any = j != balls[k] && touch(balls[k], j, driven) && driven;
    if (!any) return;
    for (std::size_t k = 0; k < balls.size(); ++k)
      for (std::size_t j = 0; j < count_; ++j) {
        if (std::find(balls.begin(), balls.end(), j) != balls.end() || !touch(balls[k], j, driven)) continue;
        const std::size_t known = balls.size();
        bring(j, watch);
        balls.push_back(j);
        let_go(balls, watch);
        for (std::size_t m = known; m < balls.size(); ++m) begin(balls[m]);
      }
    std::ranges::sort(balls);
    find_contacts(balls);
    find_forces(balls);
    stop_approach(balls);
    find_forces(balls);
    press(balls);
  }

  /// Of these balls with each other and with cushions.
  void find_contacts(const std::vector<std::size_t>& balls) {
    using std::abs;
    contacts_.clear();
    bool driven = false;
    for (std::size_t a = 0; a < balls.size(); ++a) {
      const BallTrack<T>& track = slots_[balls[a]].track;
      const int first = static_cast<int>(a);
      for (std::size_t b = a + 1; b < balls.size(); ++b)
        if (touch(balls[a], balls[b], driven)) {
          const Vec2<T> between = slots_[balls[b]].track.state().at - track.state().at;
          contacts_.push_back({first, static_cast<int>(b), between / norm(between)});
        }
      for (int k = 0; k < 2; ++k)
        if (const Contact c = track.on(k)) {
          const Vec2<T> away = track.boundary().normal(c, track.state().at);
          if (abs(dot(value(away), value(track.state().velocity))) <= held_speed_)
            contacts_.push_back({first, Pressed<T>::none, -away});
        }
    }
  }

  void find_forces(const std::vector<std::size_t>& balls) {
    own_.clear();
    inertias_.clear();
    for (const std::size_t i : balls) {
      own_.push_back(slots_[i].in_play ? pull(i) : Vec2<T>{T(0), T(0)});
      inertias_.push_back(inertia(slots_[i].track.arc(), slots_[i].track.boundary().body));
    }
    rates_ = own_;
    for (Pressed<T>& c : contacts_) c.force = T(0), c.keeps = false;
    press_apart(std::span(contacts_), std::span(rates_), std::span<const double>(inertias_));
  }

  /// Where there are forces nothing is left of the speed along them, and none approach elsewhere.
  void stop_approach(const std::vector<std::size_t>& balls) {
    rates_.clear();
    for (const std::size_t i : balls) rates_.push_back(slots_[i].track.state().velocity);
    bool any = false;
    for (Pressed<T>& c : contacts_) {
      c.keeps = value(c.force) > Number(0);
      c.force = T(0);
      const Number parting = value(parting_rate<T>(c, rates_));
      any = any || parting < -rounding_.still || (c.keeps && parting > rounding_.still);
    }
    if (!any) return;
    press_apart(std::span(contacts_), std::span(rates_), std::span<const double>(inertias_));
    for (std::size_t a = 0; a < balls.size(); ++a) {
      BallTrack<T>& track = slots_[balls[a]].track;
      const Vec2<T> more = rates_[a] - track.state().velocity;
      if (more == Vec2<T>{T(0), T(0)}) continue;
      track.nudge(motion_, more);
      begin(balls[a]);
    }
  }

  void press(const std::vector<std::size_t>& balls) {
    for (std::size_t a = 0; a < balls.size(); ++a) {
      const Vec2<T> push = rates_[a] - own_[a];
      if (!(push == Vec2<T>{T(0), T(0)})) slots_[balls[a]].track.press(push);
    }
    for (const Pressed<T>& c : contacts_) {
      if (!(value(c.force) > Number(0))) continue;
      const std::size_t i = balls[static_cast<std::size_t>(c.first)];
      if (c.second != Pressed<T>::none)
        held_.push_back(in_order(i, balls[static_cast<std::size_t>(c.second)]));
      else
        hold_at_cushion(slots_[i].track, value(c.normal));
    }
  }

  static void hold_at_cushion(BallTrack<T>& track, const Vec2<Number>& into) {
    for (int k = 0; k < 2; ++k)
      if (const Contact c = track.on(k);
          c && dot(track.boundary().normal(c, value(track.state().at)), into) < Number(0))
        track.hold(c);
  }

  Motion motion_;
  Cushion cushion_;
  BallBall law_;
  std::size_t count_;
  Rounding<Number> rounding_{};
  Number held_speed_{0};  ///< m/s: slower contacts hold
  T now_{0};
  std::vector<Slot> slots_;
  std::vector<Number> meetings_;  ///< s, of each pair, the lower number first
  std::vector<std::size_t> changed_;
  std::vector<Two> held_;  ///< pairs that press on each other
  // Of the balls that do, while they are looked at:
  std::vector<Pressed<T>> contacts_;
  std::vector<Vec2<T>> rates_, own_;
  std::vector<double> inertias_;
};

}  // namespace bankshot
