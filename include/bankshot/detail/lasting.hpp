// SPDX-License-Identifier: MIT
//
// Contacts that last: balls that touch, do not approach or part to speak of, and that friction drives together. They
// are held apart by forces (detail/pressed.hpp), which is no event; when one of them changes its arc all are looked at
// anew.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "bankshot/detail/balls_in_play.hpp"
#include "bankshot/detail/pressed.hpp"

namespace bankshot {

template <class T, class Motion>
class LastingContacts {
 public:
  using Number = Real<T>;
  using Balls = BallsInPlay<T, Motion>;

  /// `launch`: |v| + R|ω| of it [m/s].
  explicit LastingContacts(const Number& launch)
      : held_speed_(std::min<Number>(Number(tolerance::held_contact), Number(tolerance::held_part) * launch)) {}

  /// Two that meet no faster than this [m/s] are held at once.
  const Number& slowest_meeting() const { return held_speed_; }

  /// These two press on each other.
  bool is_held(std::size_t i, std::size_t j) const {
    return std::ranges::any_of(held_, [&](const auto& pair) { return pair == Two{std::min(i, j), std::max(i, j)}; });
  }

  /// Forces between these balls and others end here; the others join them.
  template <class Watch>
  void let_go(Balls& in, std::vector<std::size_t>& balls, Watch&& watch) {
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
      held_.erase(these, held_.end());
    }
  }

  /// Of balls whose arcs have just begun: those that friction drives into another are held apart from it. Joins to
  /// `balls` whoever they touch.
  template <class Watch>
  void hold(Balls& in, std::vector<std::size_t>& balls, Watch&& watch) {
    bool driven = false, any = false;
    joined_.assign(in.count(), false);
    for (std::size_t k = 0; k < balls.size() && !any; ++k) {
      joined_[balls[k]] = true;  // a pair is looked at once
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
        let_go(in, balls, watch);
        for (std::size_t m = known; m < balls.size(); ++m) joined_[balls[m]] = true, in.begin(balls[m]);
      }
    std::ranges::sort(balls);
    find_contacts(in, balls);
    find_forces(in, balls);
    stop_approach(in, balls);
    find_forces(in, balls);
    press(in, balls);
  }

 private:
  using Two = std::pair<std::size_t, std::size_t>;  ///< the lower number first

  /// What rules out most pairs, at a fraction of what touch costs.
  static bool may_touch(const Balls& in, std::size_t i, std::size_t j) {
    return in.balls[i].in_play && in.balls[j].in_play && !in.too_far(i, j, Number(0));
  }

  /// Two balls that may touch do, and neither approach nor part, to speak of. If so `driven` says whether they do
  /// approach, or will.
  bool touch(const Balls& in, std::size_t i, std::size_t j, bool& driven) const {
    using std::abs;
    const Apart<Number> apart = in.seen(i, j, value(in.now));
    // Twice what a meeting counts as touching: rounding must not part two that have just met.
    const Number far = norm(apart.at);
    if (!(far - in.reach(i, j) < 2 * in.rounding.touch)) return false;
    const Vec2<Number> normal = apart.at / far;
    const Number parting = dot(normal, apart.velocity);
    const auto pull = [&](std::size_t k) { return first_acceleration(value(in.balls[k].track.arc())); };
    driven = parting < -in.rounding.still || dot(normal, Vec2<Number>(pull(j) - pull(i))) < Number(0);
    return abs(parting) <= held_speed_;
  }

  /// Of these balls with each other and with cushions.
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
      inertias_.push_back(inertia(in.balls[i].track.arc(), in.balls[i].track.boundary().body));
    }
    rates_ = own_;
    for (Pressed<T>& c : contacts_) c.force = T(0), c.keeps = false;
    press_apart(std::span(contacts_), std::span(rates_), std::span<const double>(inertias_));
  }

  /// Where there are forces nothing is left of the speed along them, and none approach elsewhere.
  void stop_approach(Balls& in, const std::vector<std::size_t>& balls) {
    rates_.clear();
    for (const std::size_t i : balls) rates_.push_back(in.balls[i].track.state().velocity);
    bool any = false;
    for (Pressed<T>& c : contacts_) {
      c.keeps = value(c.force) > Number(0);
      c.force = T(0);
      const Number parting = value(parting_rate<T>(c, rates_));
      any = any || parting < -in.rounding.still || (c.keeps && parting > in.rounding.still);
    }
    if (!any) return;
    press_apart(std::span(contacts_), std::span(rates_), std::span<const double>(inertias_));
    for (std::size_t a = 0; a < balls.size(); ++a) {
      BallTrack<T>& track = in.balls[balls[a]].track;
      const Vec2<T> more = rates_[a] - track.state().velocity;
      if (more == Vec2<T>{T(0), T(0)}) continue;
      track.nudge(in.motion, more);
      in.begin(balls[a]);
    }
  }

  void press(Balls& in, const std::vector<std::size_t>& balls) {
    for (std::size_t a = 0; a < balls.size(); ++a) {
      const Vec2<T> push = rates_[a] - own_[a];
      if (!(push == Vec2<T>{T(0), T(0)})) in.balls[balls[a]].track.press(push);
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

  Number held_speed_;      ///< m/s
  std::vector<Two> held_;  ///< pairs that press on each other
  // Of the balls that do, while they are looked at:
  std::vector<Pressed<T>> contacts_;
  std::vector<Vec2<T>> rates_, own_;
  std::vector<double> inertias_;
  std::vector<char> joined_;  ///< of all balls: it is looked at
};

}  // namespace bankshot
