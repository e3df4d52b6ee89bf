// SPDX-License-Identifier: MIT
//
// Persistent contacts: balls that touch, neither approach nor part noticeably, and are driven together by friction.
// Contact forces hold them apart (detail/pressed.hpp); this is not an event. When one of them changes its arc, all
// their contacts are found anew.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "bankshot/detail/balls_in_play.hpp"
#include "bankshot/detail/pressed.hpp"

namespace bankshot::detail {

template <class T, class Motion>
class LastingContacts {
 public:
  using Number = Real<T>;
  using Balls = BallsInPlay<T, Motion>;

  /// `launch` is the speed scale of the launch, √squared_scale [m/s].
  explicit LastingContacts(const Number& launch)
      : held_speed_(std::min<Number>(Number(tolerance::held_contact), Number(tolerance::held_part) * launch)) {}

  /// Returns the speed up to which two balls that meet are held at once [m/s].
  const Number& slowest_meeting() const { return held_speed_; }

  /// Returns true if these two press on each other.
  bool is_held(std::size_t i, std::size_t j) const { return has(held_, i, j); }

  /// Ends the forces between these balls and others, and adds the others to `balls`. hold() brings the forces back if
  /// nothing has changed.
  template <class Watch>
  void let_go(Balls& in, std::vector<std::size_t>& balls, Watch&& watch) {
    let_go_.clear();
    release(in, balls, watch);
  }

  /// Holds balls apart that friction drives into each other, and adds every ball that they touch to `balls`. Their arcs
  /// must have just begun, and the glances of all balls must be current.
  template <class Watch>
  void hold(Balls& in, std::vector<std::size_t>& balls, Watch&& watch) {
    bool driven = false, any = false;
    joined_.assign(in.count(), false);
    for (std::size_t k = 0; k < balls.size() && !any; ++k) {
      joined_[balls[k]] = true;  // each pair is checked once
      for (std::size_t j = 0; j < in.count() && !any; ++j)
        any = !joined_[j] && may_touch(in, balls[k], j) && touch(in, balls[k], j, driven) && driven;
    }
    if (!any) return;
    for (const std::size_t k : balls) joined_[k] = true;
    for (std::size_t k = 0; k < balls.size(); ++k)
      for (std::size_t j = 0; j < in.count(); ++j) {
        if (joined_[j] || !may_touch(in, balls[k], j) || !touch(in, balls[k], j, driven)) continue;
        const std::size_t known = balls.size();
        in.bring(j, watch);
        balls.push_back(j);
        release(in, balls, watch);
        for (std::size_t m = known; m < balls.size(); ++m) joined_[balls[m]] = true, in.begin(balls[m]);
      }
    std::ranges::sort(balls);
    find_contacts(in, balls);
    find_forces(in, balls);
    if (stop_approach(in, balls)) find_forces(in, balls);
    const Number lasts = piece(in, balls);
    turn(in, balls, lasts);
    press(in, balls, lasts);
  }

 private:
  using Two = std::pair<std::size_t, std::size_t>;  ///< the lower number first

  template <class Watch>
  void release(Balls& in, std::vector<std::size_t>& balls, Watch&& watch) {
    for (std::size_t k = 0; k < balls.size() && !held_.empty(); ++k) {
      const auto these = std::partition(held_.begin(), held_.end(), [&](const Two& pair) {
        return pair.first != balls[k] && pair.second != balls[k];
      });
      for (auto pair = these; pair != held_.end(); ++pair) {
        const std::size_t other = pair->first == balls[k] ? pair->second : pair->first;
        if (std::find(balls.begin(), balls.end(), other) != balls.end()) continue;
        const Arc<T>& arc = in.balls[other].track.arc();
        const bool rolls = arc.pressed == Press::rolls && !arc.chord;
        in.bring(other, watch);
        if (rolls) in.slow_to_rest(in.balls[other]);
        balls.push_back(other);
      }
      let_go_.insert(let_go_.end(), these, held_.end());
      held_.erase(these, held_.end());
    }
  }

  static bool has(const std::vector<Two>& pairs, std::size_t i, std::size_t j) {
    return std::ranges::find(pairs, Two{std::min(i, j), std::max(i, j)}) != pairs.end();
  }

  /// Returns false for most pairs, at a fraction of the cost of touch().
  bool may_touch(const Balls& in, std::size_t i, std::size_t j) const {
    return in.balls[i].in_play && in.balls[j].in_play && (!in.are_apart(i, j) || has(let_go_, i, j));
  }

  /// Returns true if two balls that may touch do so, and neither approach nor part noticeably. `driven` then tells if
  /// they approach, or will. Two balls that were held until this moment may be a little apart if one goes round the
  /// other.
  bool touch(const Balls& in, std::size_t i, std::size_t j, bool& driven) const {
    using std::abs;
    const bool were_held = has(let_go_, i, j);
    const Apart<Number> apart = in.seen(i, j, value(in.now));
    // Twice the touching tolerance of a meeting, so that rounding does not part two that have just met.
    const Number far = norm(apart.at), near = were_held ? Number(tolerance::held_gap) : 2 * in.rounding.touch;
    if (!(far - in.reach(i, j) < near)) return false;
    const Vec2<Number> normal = apart.at / far;
    const Number parting = dot(normal, apart.velocity);
    const auto pull = [&](std::size_t k) { return first_acceleration(value(in.balls[k].track.arc())); };
    driven = parting < -in.rounding.still || dot(normal, Vec2<Number>(pull(j) - pull(i))) < Number(0);
    return abs(parting) <= (were_held ? Number(tolerance::slow_contact) : held_speed_);
  }

  /// Lists the contacts of these balls with each other and with cushions.
  void find_contacts(const Balls& in, const std::vector<std::size_t>& balls) {
    using std::abs;
    contacts_.clear();
    bool driven = false;
    for (std::size_t a = 0; a < balls.size(); ++a) {
      const BallTrack<T>& track = in.balls[balls[a]].track;
      const int first = static_cast<int>(a);
      for (std::size_t b = a + 1; b < balls.size(); ++b)
        if (may_touch(in, balls[a], balls[b]) && touch(in, balls[a], balls[b], driven)) {
          const Vec2<T> between = in.balls[balls[b]].track.state().at - track.state().at;
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

  void find_forces(const Balls& in, const std::vector<std::size_t>& balls) {
    own_.clear();
    inertias_.clear();
    for (const std::size_t i : balls) {
      own_.push_back(in.balls[i].in_play ? first_acceleration(in.balls[i].track.arc()) : Vec2<T>{T(0), T(0)});
      inertias_.push_back(inertia(in.balls[i].track.arc(), in.body(i)));
    }
    rates_ = own_;
    for (Pressed<T>& c : contacts_) c.force = T(0), c.keeps = false;
    settle_forces();
  }

  bool settle_forces(int sweeps = most_sweeps) {
    const auto found = Forces<T>(contacts_, rates_, inertias_).settle(sweeps);
    rounding_ = found.rounding;
    return found.settled;
  }

  /// Removes the remaining speeds at contacts: the whole speed if there is a force, else only an approach. A resting
  /// ball goes on resting; moved so little, it would come to rest again and again. Returns false if there was nothing
  /// to remove.
  bool stop_approach(Balls& in, const std::vector<std::size_t>& balls) {
    speeds_.clear();
    for (const std::size_t i : balls) speeds_.push_back(in.balls[i].track.state().velocity);
    const auto moves = [&](const Pressed<T>& c) {
      const Number parting = value(dot(c.normal, relative<T>(c, speeds_)));
      return parting < -in.rounding.still || (value(c.force) > Number(0) && parting > in.rounding.still);
    };
    if (std::ranges::none_of(contacts_, moves)) return false;
    for (Pressed<T>& c : contacts_) c.keeps = value(c.force) > Number(0), c.force = T(0);
    std::swap(rates_, speeds_);
    for (std::size_t a = 0; a < balls.size(); ++a)
      if (Balls::stands(value(in.balls[balls[a]].track.arc()))) inertias_[a] = forever;
    if (!settle_forces(sweeps_of_a_wedge)) {
      stop_slow();
      settle_forces();
    }
    for (std::size_t a = 0; a < balls.size(); ++a) {
      BallTrack<T>& track = in.balls[balls[a]].track;
      const Vec2<T> more = rates_[a] - track.state().velocity;
      if (more == Vec2<T>{T(0), T(0)}) continue;
      track.nudge(in.motion, more);
      in.begin(balls[a]);
    }
    return true;
  }

  /// Speeds that take more sweeps than this are those of balls in a wedge, which come to rest in it.
  static constexpr int sweeps_of_a_wedge = 1000;
  void stop_slow() {
    for (Pressed<T>& c : contacts_) c.force = T(0);
    for (std::size_t a = 0; a < rates_.size(); ++a) {
      if (!Balls::hardly_moves(rates_[a])) continue;
      rates_[a] = {T(0), T(0)};
      inertias_[a] = forever;
    }
  }

  /// Motion of a pair across its line of centres.
  struct Across {
    T speed;        ///< m/s
    Number brakes;  ///< m/s², deceleration of that speed; negative if it grows
    Number reach;   ///< m
    Number turns() const { return value(speed) * value(speed) / reach; }  ///< m/s², centripetal
  };
  Across across(const Balls& in, const std::vector<std::size_t>& balls, const Pressed<T>& c) const {
    const std::size_t i = balls[static_cast<std::size_t>(c.first)], j = balls[static_cast<std::size_t>(c.second)];
    const Vec2<T> along = perpendicular(c.normal);
    const T speed = dot(along, Vec2<T>(in.balls[j].track.state().velocity - in.balls[i].track.state().velocity));
    const Number pull = value(dot(along, relative<T>(c, rates_)));
    return {speed, value(speed) > Number(0) ? Number(-pull) : pull, in.reach(i, j)};
  }

  static bool is_pressed_pair(const Pressed<T>& c) {
    return c.second != Pressed<T>::none && value(c.force) > Number(0);
  }

  /// Returns how long a piece may last [s], before a line of centres or a friction turns too far.
  Number piece(const Balls& in, const std::vector<std::size_t>& balls) const {
    using std::abs;
    Number fastest(0);  // rad/s
    for (const Pressed<T>& c : contacts_) {
      if (!is_pressed_pair(c)) continue;
      const Across pair = across(in, balls, c);
      fastest = std::max<Number>(fastest, abs(value(pair.speed)) / pair.reach);
    }
    for (std::size_t a = 0; a < balls.size(); ++a)
      fastest = std::max<Number>(fastest, friction_turns(in.balls[balls[a]].track.arc(), Vec2<T>(rates_[a] - own_[a])));
    return std::clamp<Number>(Number(tolerance::turned) / fastest, Number(tolerance::longest_piece),
                              Number(tolerance::quiet_piece));
  }

  /// Sets the centripetal acceleration of pairs in contact, from the least speed across during the piece (pressed.hpp).
  /// Forces elsewhere then change how a pair is braked. A pair that might overlap because of that gets none.
  void turn(const Balls& in, const std::vector<std::size_t>& balls, const Number& lasts) {
    using std::abs, std::sqrt;
    const auto lost = [&](const Number& brakes) { return std::max<Number>(brakes, Number(0)) * lasts; };
    Number most(0);
    for (const Pressed<T>& c : contacts_)
      if (is_pressed_pair(c)) most = std::max<Number>(most, across(in, balls, c).turns());
    if (most == Number(0)) return;
    for (Pressed<T>& c : contacts_) {
      if (!is_pressed_pair(c)) continue;
      const Across pair = across(in, balls, c);
      const Number speed = abs(value(pair.speed)), least = speed - lost(Number(pair.brakes + most));
      if (least > Number(0)) c.turns = pair.speed * pair.speed * Number(least * least / (speed * speed)) / pair.reach;
    }
    for (bool any = true; any;) {
      settle_forces();
      any = false;
      for (Pressed<T>& c : contacts_) {
        if (!(value(c.turns) > Number(0))) continue;
        const Across pair = across(in, balls, c);
        const Number least = sqrt(Number(value(c.turns) * pair.reach));
        if (abs(value(pair.speed)) - lost(pair.brakes) >= least) continue;
        c.turns = T(0);
        any = true;
      }
    }
  }

  void press(Balls& in, const std::vector<std::size_t>& balls, const Number& lasts) {
    using std::sqrt;
    for (std::size_t a = 0; a < balls.size(); ++a) {
      BallTrack<T>& track = in.balls[balls[a]].track;
      const Vec2<T> push = rates_[a] - own_[a];
      const Number force = Number(inertias_[a]) * Number(sqrt(dot(value(push), value(push))));
      const bool moves = Balls::stands(value(track.arc())) ? force > rounding_ : force > Number(0);
      if (moves) track.press(push, lasts);
    }
    for (const Pressed<T>& c : contacts_) {
      if (!(value(c.force) > Number(0))) continue;
      const std::size_t i = balls[static_cast<std::size_t>(c.first)];
      if (c.second != Pressed<T>::none)
        held_.push_back(Two{i, balls[static_cast<std::size_t>(c.second)]});
      else
        hold_at_cushion(in.balls[i].track, value(c.normal));
    }
  }

  static void hold_at_cushion(BallTrack<T>& track, const Vec2<Number>& into) {
    for (int k = 0; k < 2; ++k)
      if (const Contact c = track.on(k);
          c && dot(track.boundary().normal(c, value(track.state().at)), into) < Number(0))
        track.hold(c);
  }

  Number held_speed_;        ///< m/s
  std::vector<Two> held_;    ///< pairs that press on each other
  std::vector<Two> let_go_;  ///< pairs that did until let_go()
  // Working data of hold() about the balls in contact:
  std::vector<Pressed<T>> contacts_;
  std::vector<Vec2<T>> rates_, own_, speeds_;
  std::vector<double> inertias_;
  Number rounding_{0};        ///< N, rounding error of forces
  std::vector<char> joined_;  ///< per ball: it needs no further check
};

}  // namespace bankshot::detail
