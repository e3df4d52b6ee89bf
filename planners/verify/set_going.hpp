// SPDX-License-Identifier: MIT
//
// The shot after the first contact. The balls of a combination set each other going in turn, and the last of them is on
// its way to the target; in a carom the cue ball itself is. No other contact may happen. Only these balls move; all
// others are obstacles.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "planners/verify/goal.hpp"
#include "planners/verify/line_of_travel.hpp"
#include "planners/verify/sequence_check.hpp"

namespace bankshot::planning {

template <class Motion, class Cushion>
class SetGoing {
 public:
  /// `before` has checked the cue ball's bounces before the contact. `out` has its path up to there, and gets the rest.
  SetGoing(const SearchRequest& request, const Motion& motion, const Cushion& cushion, const Objects::Chain& chain,
           const Goal& goal, const SequenceCheck& before, Replay& out)
      : request_(request),
        motion_(motion),
        cushion_(cushion),
        chain_(chain),
        goal_(goal),
        carom_(request.problem->carom()),
        asked_{goal.min, goal.max, goal.sequence},
        bounces_(out.bounces()),
        check_(before),
        out_(out),
        last_(chain.balls.front()->at_rest.at) {}

  /// Follows the shot from the moment when `struck`, the cue ball, touches the first ball, `begin` seconds after the
  /// launch.
  void run(const State<double>& struck, double begin) {
    std::vector<BallStart<double>> balls;
    balls.reserve(1 + chain_.balls.size());
    balls.push_back({&chain_.moving.front(), struck, 0});
    for (std::size_t i = 0; i < chain_.balls.size(); ++i)
      balls.push_back({&chain_.moving[i + 1], {.at = chain_.balls[i]->at_rest.at}, chain_.balls[i]->ball});
    ManyBalls sim(std::span<const BallStart<double>>(balls), motion_, cushion_, collisions(request_.puzzle().physics));
    begin_ = begin;
    incoming_ = {struck.at, struck.velocity};
    for (;;) {
      bool arrived = false;
      const auto look = [&](int ball, double began, const State<double>& from, const Arc<double>& arc,
                            double travelled) {
        if (ball == on_its_way() && set_ > 0) arrived = arrived || passes(began, from, arc, travelled);
      };
      const BallEvent e = sim.step(forever, look);
      // A ball that still comes nearer when its slide, or a piece of it, ends is closest on the next arc.
      const bool its = e.ball == on_its_way() || e.event.contact == Contact::ball(number());
      const bool others_meet = !its && e.event.kind == EventKind::ball;
      if (others_meet && !arrived) sim.stop(look);  // the shot ends here, so the path up to now counts
      if (near_end_ && (others_meet || (its && e.event.kind != EventKind::slide_to_roll))) arrived = out_.made = true;
      if (arrived || over(e, sim)) return void(out_.work += sim.work());
    }
  }

 private:
  /// Returns the moving ball that is to touch the next one, or to reach the target; 0 is the cue ball.
  int on_its_way() const { return carom_ ? 0 : static_cast<int>(set_); }
  int number() const { return on_its_way() == 0 ? 0 : chain_.balls[set_ - 1]->ball; }
  bool all_set() const { return set_ == chain_.balls.size(); }

  template <class Sim>
  bool over(const BallEvent& e, const Sim& sim) {
    const bool its = e.ball == on_its_way() && set_ > 0;
    switch (e.event.kind) {
      case EventKind::ball:
        return meets(e, sim);
      case EventKind::cushion:
        return its && bounces(e.event, sim);
      case EventKind::jaw:
        if (its) touch_jaw(request_, e.event.contact, {sim.state(e.ball).at, incoming_.heading}, jaw_, out_.path);
        return false;
      case EventKind::pocket:
        return its && falls(e.event.contact, sim);
      case EventKind::rest:
        return its && rests(sim);
      case EventKind::horizon:
        return fail(FailureReason::fell_short);
      default:
        return false;
    }
  }

  bool counts() const { return bounces_ >= asked_.min && !check_.open(); }

  template <class Sim>
  bool meets(const BallEvent& e, const Sim& sim) {
    if (!all_set() && e.ball == on_its_way() && e.event.contact == Contact::ball(chain_.balls[set_]->ball))
      return sets_going(sim);
    const State<double>& now = sim.state(e.ball);
    const AimPoint* const aim_point =
        carom_ && e.ball == 0 && counts() ? request_.problem->aim_point_taken_by(e.event.contact, now.at) : nullptr;
    if (!aim_point || !goal_.allows(request_, *aim_point)) return fail(FailureReason::hit_ball, e.event.contact);
    out_.path.arrival = {begin_ + sim.time(), norm(now.velocity), now.at};
    note_hit(e.event.contact.index, aim_point->at);
    touched(*aim_point, incoming_, out_);
    return true;
  }

  /// Notes that the next ball is touched, by the ball that was on its way to it.
  template <class Sim>
  bool sets_going(const Sim& sim) {
    const Objects::Object& next = *chain_.balls[set_];
    if (set_ > 0 && !counts()) return fail(FailureReason::hit_ball, Contact::ball(next.ball));
    note_hit(next.ball, next.at_rest.at);
    ++set_;
    const State<double>& now = sim.state(on_its_way());
    incoming_ = {now.at, now.velocity};
    if (carom_) return false;
    out_.path.then.push_back({next.ball, {}});
    asked_ = goal_.of_sent(request_, set_ - 1);
    check_ = SequenceCheck(asked_.sequence);
    bounces_ = 0;
    jaw_.reset();
    began_ = sim.time();
    last_ = next.at_rest.at;
    return false;
  }

  void note_hit(int ball, const Vec2d& at) {
    const double reach = request_.problem->boundary_of(number()).rim(Contact::ball(ball))->radius;
    out_.path.hits.push_back(hit_by(incoming_, norm(incoming_.heading), ball, at, reach, bounces_));
  }

  template <class Sim>
  bool bounces(const Event& e, const Sim& sim) {
    last_ = sim.state(on_its_way()).at;
    // A bounce off a cushion that it touches, in the instant in which it is hit, does not count.
    if (!carom_ && sim.time() == began_) return false;
    if (bounces_ == asked_.max) return fail(FailureReason::extra_cushion, e.contact);
    if (!check_.accepts(bounces_, e)) return fail(FailureReason::wrong_cushion, e.contact);
    ++bounces_;
    (carom_ ? out_.path.cushions : out_.path.then.back().cushions).push_back(e.contact);
    return false;
  }

  /// Looks along an arc of the ball on its way for the closest approach to a target point; returns whether it is made.
  bool passes(double began, const State<double>& from, const Arc<double>& arc, double travelled) {
    const auto on_path = [&](double t) {
      return advance(motion_, request_.problem->boundary_of(number()).body, from, arc, t);
    };
    const State<double> end = on_path(travelled);
    last_ = end.at;
    incoming_ = {last_, end.velocity};
    if (request_.stop || !all_set() || !counts()) return false;
    for (const AimPoint& aim_point : request_.problem->aim_points) {
      if (aim_point.captures() || aim_point.ball != number()) continue;
      const double t = detail::closest_time(arc, travelled, aim_point.at);
      const State<double> there = on_path(t);
      const double miss = norm(there.at - aim_point.at);
      if (miss < out_.miss) {
        out_.miss = miss;
        out_.path.arrival = {begin_ + began + arc.seconds(t), norm(there.velocity), there.at};
      }
      near_end_ = miss <= aim_point.reach && !(t < travelled);
      if (miss <= aim_point.reach && t < travelled) return out_.made = true;
    }
    return false;
  }

  template <class Sim>
  bool falls(Contact pocket, const Sim& sim) {
    const State<double>& now = sim.state(on_its_way());
    const AimPoint* const aim_point =
        all_set() && counts() ? request_.problem->aim_point_taken_by(pocket, now.at, number()) : nullptr;
    if (!aim_point || !goal_.allows(request_, *aim_point)) return fail(FailureReason::pocketed, pocket);
    out_.made = true;
    if (chain_.balls.size() == 1 && sim.in_play(0)) out_.cue = sim.state_now(0);
    out_.path.arrival = {begin_ + sim.time(), norm(now.velocity), now.at};
    measure(request_, *aim_point, jaw_ ? *jaw_ : norm(now.velocity) > 0 ? Line{now.at, now.velocity} : incoming_, out_);
    return true;
  }

  template <class Sim>
  bool rests(const Sim& sim) {
    const Vec2d at = sim.state(on_its_way()).at;
    if (!request_.stop || !all_set() || !counts()) return fail(FailureReason::fell_short);
    rested(request_, number(), at, begin_ + sim.time(), out_);
    return true;
  }

  bool fail(FailureReason reason, Contact contact = {}) {
    if (!(out_.miss < std::numeric_limits<double>::infinity())) {
      out_.miss = norm(last_ - request_.problem->nearest_aim_point(last_, number()).at);
      out_.path.arrival = {begin_, 0, last_};
    }
    out_.failure = {reason, contact};
    return true;
  }

  const SearchRequest& request_;
  const Motion& motion_;
  const Cushion& cushion_;
  const Objects::Chain& chain_;
  const Goal& goal_;
  const bool carom_;
  Goal::Bounces asked_;  ///< of the ball that is on its way
  int bounces_;
  SequenceCheck check_;
  Replay& out_;
  std::size_t set_ = 0;    ///< number of balls in the chain that were touched
  double begin_ = 0;       ///< s after the launch: time 0 of the simulation
  double began_ = 0;       ///< s, when the ball on its way was set going
  bool near_end_ = false;  ///< a target point was within reach at the end of an arc
  Vec2d last_;
  Line incoming_{};
  std::optional<Line> jaw_{};
};

}  // namespace bankshot::planning
