// SPDX-License-Identifier: MIT
//
// The place of a ball of a recorded shot at any time: its locked path, stored. The contacts it meets are given, so that
// a change of launch or of coefficients moves every place smoothly.
#pragma once

#include <list>
#include <vector>

#include "bankshot/scene/recording.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::planning {

/// The contacts given for one ball.
struct Told {
  int ball = 0;
  Route before{};          ///< for a ball struck by the cue ball: the cue ball's route up to that contact
  Route route{};           ///< contacts of the ball itself
  double until = forever;  ///< s since the launch: beyond it fits do not follow the ball
};

/// Returns the contacts of one ball of a simulated shot, up to `until` [s since the launch].
Told told_of(const Trajectory& shot, int ball, double until);

/// The balls of a scene as they stand.
class Stand {
 public:
  explicit Stand(const ShotRequest& scene);
  Stand(const Stand&) = delete;
  Stand& operator=(const Stand&) = delete;

  const Boundary& struck() const { return struck_; }
  std::span<const StandingBall> others() const { return others_; }

 private:
  Boundary struck_;
  std::list<Boundary> boundaries_;
  std::vector<StandingBall> others_;
};

template <class T>
class Way {
 public:
  explicit Way(const Vec2<T>& from) : stood_(from) {}

  void operator()(const Arc<T>& arc, const T& on) {  // called by follow_locked as its `watch`
    legs_.push_back({end_, arc, on});
    end_ += arc.seconds(on);
  }
  void begin(const T& time, const Vec2<T>& at) { end_ = time, stood_ = at; }

  /// Returns the place at a time since the launch.
  Vec2<T> at(const T& time) const {
    std::size_t i = legs_.size();
    while (i > 0 && value(time) < value(legs_[i - 1].begin)) --i;
    if (i == 0) return stood_;
    const Leg& leg = legs_[i - 1];
    const T since = time - leg.begin, p = leg.arc.parameter(since);
    return leg.arc.position(value(p) < value(leg.on) ? p : leg.on);
  }
  const T& time() const { return end_; }  ///< time up to which the path is known
  Vec2<T> end() const { return legs_.empty() ? stood_ : legs_.back().arc.position(legs_.back().on); }

 private:
  struct Leg {
    T begin;
    Arc<T> arc;
    T on;
  };
  Vec2<T> stood_;
  T end_{0};
  std::vector<Leg> legs_;
};

/// Follows the ball after its last contact until it rests, or until `lasts` [s since the launch].
template <class T, class Motion>
void go_on(const Boundary& boundary, const Motion& motion, State<T> state, double lasts, Way<T>& way) {
  const Vec2<Real<T>> from = value(state.at);
  while (value(way.time()) < lasts && !is_lost(motion, boundary, from, value(state.at))) {
    const Arc<T> arc = motion.arc(boundary.body, state);
    if (!(value(arc.duration) < forever)) return way(arc, T(lasts));
    way(arc, arc.duration);
    if (!arc.goes_on()) return;
    state = advance(motion, boundary.body, state, arc, arc.duration);
    motion.finish(boundary.body, state, arc);
  }
}

/// Returns the path up to where the ball rests, or to `lasts` [s since the launch].
template <class T, class Motion, class Cushion>
Way<T> way_of(const Stand& stand, const BallBallOf<T>& law, const Motion& motion, const Cushion& cushion,
              const Told& told, const State<T>& start, double lasts) {
  const RouteBallsOf<T> balls(stand.struck(), stand.others(), law, told.before.empty());
  Way<T> way(start.at);
  const auto on_from = [&](const State<T>& from) {
    const auto path = follow_locked(balls, motion, cushion, std::span<const Meeting>(told.route), from, way);
    go_on(balls.boundary(told.ball), motion, path.state, lasts, way);
  };
  if (told.before.empty()) return on_from(start), way;
  const auto sent = follow_locked(balls, motion, cushion, std::span<const Meeting>(told.before), start);
  way.begin(sent.time, sent.ball == told.ball ? sent.state.at : to<T>(balls.standing(told.ball).at));
  if (sent.ball == told.ball) on_from(sent.state);
  return way;
}

}  // namespace bankshot::planning
