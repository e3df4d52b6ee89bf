// SPDX-License-Identifier: MIT
#include "planners/verify/replay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/set_going.hpp"

namespace bankshot::planning {
namespace {

/// A simulation checked against a goal, leg by leg.
template <class Motion, class Cushion>
class Follower {
 public:
  Follower(const SearchRequest& request, const Motion& motion, const Cushion& cushion, const Launch& launch,
           const Goal& goal, bool tracing)
      : request_(request),
        motion_(motion),
        cushion_(cushion),
        goal_(goal),
        tracing_(tracing),
        stop_(request.stop && !tracing),
        at_start_(!request.problem->touched.empty()),
        check_(goal.sequence),
        sim_(request.problem->boundary, motion, cushion, start_of(request, launch)),
        out_{{}, SpeedAccount(deceleration(request.puzzle().physics))} {}

  Trace run() {
    follow();
    out_.replay.work += sim_.work();
    return std::move(out_);
  }

 private:
  void follow() {
    for (;;) {
      bool arrived = false;  // on a piece before the last
      const Event e = sim_.step(
          forever, [&](const Arc<double>&, double) { arrived = arrived || look_along_arc(EventKind::slide_to_roll); });
      if (arrived || look_along_arc(e.kind)) return;
      if (tracing_) {
        out_.account.add(sim_.arc(), sim_.travelled());
        if (out_.account.beyond(request_.speed.high)) return fail(FailureReason::too_long);
      }
      switch (e.kind) {
        case EventKind::cushion:
          if (bounces_in_place()) return fail(FailureReason::in_place, e.contact);
          if (bounces() == goal_.max) return fail(FailureReason::extra_cushion, e.contact);
          if (!check_.accepts(bounces(), e)) return fail(FailureReason::wrong_cushion, e.contact);
          if (!std::is_same_v<Cushion, Mirror> && !(dot(sim_.normal(e.contact), sim_.state().velocity) > 0))
            path_.cushion_stick = true;
          path_.cushions.push_back(e.contact);
          if (path_.touches_jaws) path_.met.push_back(e.contact);
          break;
        case EventKind::jaw:
          if (!path_.touches_jaws) path_.met = path_.cushions;
          path_.met.push_back(e.contact);
          touch_jaw(request_, e.contact, {sim_.state().at, sim_.on_arc(sim_.travelled()).velocity}, first_jaw_, path_);
          break;
        case EventKind::slide_to_roll:
          break;
        case EventKind::ball:
          if (!request_.problem->objects) return taken(e.contact);
          if (const auto* chain = request_.problem->objects->chain_by(e.contact.index);
              chain && may_set_going(e.contact))
            return set_going(*chain);
          return fail(FailureReason::hit_ball, e.contact);
        case EventKind::pocket:
          return taken(e.contact);
        case EventKind::rest:
          return rest();
        default:
          return fail(FailureReason::missed);
      }
    }
  }

  int bounces() const { return out_.replay.bounces(); }
  bool counts() const { return bounces() >= goal_.min && !check_.open(); }
  /// Returns whether the ball bounces where it stands. Legs have a length, except that between the two cushions of a
  /// corner.
  bool bounces_in_place() {
    constexpr int of_a_corner = 2;
    at_start_ = at_start_ && norm(sim_.state().at - request_.puzzle().ball.at) <= request_.problem->boundary.touch;
    return at_start_ && (request_.problem->in_vertex() || bounces() == of_a_corner);
  }
  bool may_set_going(Contact ball) const { return request_.problem->carom() || (counts() && goal_.allows(ball.index)); }

  /// Finds the closest approach to each aim point on the arc just travelled; returns whether the target is made in
  /// passing.
  bool look_along_arc(EventKind end) {
    if (stop_ || request_.problem->objects || !counts()) return false;
    for (const AimPoint& aim_point : request_.problem->aim_points) {
      if (aim_point.captures() && !tracing_) continue;
      const bool near = look_at(aim_point.at) <= aim_point.reach && !aim_point.captures();
      // A ball that still comes nearer when its slide, or a piece of it, ends is closest on the next arc.
      if (near && (closest_ < sim_.travelled() || end != EventKind::slide_to_roll)) return arrive_in_passing();
    }
    return false;
  }

  double look_at(const Vec2d& target) {
    const double t = detail::closest_time(sim_.arc(), sim_.travelled(), target);
    const State<double> there = sim_.on_arc(t);
    const double miss = norm(there.at - target);
    closest_ = t;
    if (miss < out_.replay.miss) {
      out_.replay.miss = miss;
      const Arc<double>& arc = sim_.arc();
      path_.arrival = {sim_.time() - arc.seconds(sim_.travelled()) + arc.seconds(t), norm(there.velocity), there.at};
    }
    return miss;
  }

  bool arrive_in_passing() {
    if (tracing_) out_.account.add(sim_.arc(), closest_);
    return out_.replay.made = true;
  }

  void taken(Contact by) {
    const State<double>& now = sim_.state();
    const AimPoint* const aim_point = counts() ? request_.problem->aim_point_taken_by(by, now.at) : nullptr;
    if (!aim_point || !goal_.allows(request_, *aim_point))
      return fail(by.kind == ContactKind::pocket ? FailureReason::pocketed : FailureReason::hit_ball, by);
    out_.replay.made = true;
    // A ball that stops on the pocket's circle keeps the direction of its last arc.
    const Vec2d heading = norm(now.velocity) > 0 ? now.velocity : sim_.arc().velocity;
    path_.arrival = {sim_.time(), norm(now.velocity), now.at};
    if (aim_point->cuts) {
      path_.hits.push_back(
          hit_by({now.at, heading}, norm(now.velocity), by.index, aim_point->at, aim_point->reach, bounces()));
      return touched(*aim_point, {now.at, heading}, out_.replay);
    }
    measure(request_, *aim_point, first_jaw_ ? *first_jaw_ : Line{now.at, heading}, out_.replay);
  }

  /// Continues after the cue ball has touched the first ball of a chain; those balls do the rest.
  void set_going(const Objects::Chain& chain) {
    out_.replay.miss = std::numeric_limits<double>::infinity();
    SetGoing(request_, motion_, cushion_, chain, goal_, check_, out_.replay).run(sim_.state(), sim_.time());
  }

  void rest() {
    if (!stop_ || request_.problem->objects || !counts()) return fail(FailureReason::fell_short);
    rested(request_, 0, sim_.state().at, sim_.time(), out_.replay);
  }

  /// Returns the distance [m] of the cue ball from the aim point; if an object ball is to go there, the way through
  /// that ball.
  double apart(const AimPoint& m) const {
    if (m.ball == 0) return norm(sim_.state().at - m.at);
    const Vec2d at = request_.problem->objects->find(m.ball).at_rest.at;
    return norm(sim_.state().at - at) + norm(at - m.at);
  }

  void fail(FailureReason reason, Contact contact = {}) {
    // If the ball passed the target after the bounces asked, the miss is known; otherwise it is the distance when the
    // shot failed.
    if (!(out_.replay.miss < std::numeric_limits<double>::infinity())) {
      for (const AimPoint& m : request_.problem->aim_points) out_.replay.miss = std::min(out_.replay.miss, apart(m));
      path_.arrival = {sim_.time(), norm(sim_.state().velocity), sim_.state().at};
    } else if (reason == FailureReason::extra_cushion) {
      reason = FailureReason::missed;
      contact = {};
    }
    out_.replay.failure = {reason, contact};
  }

  const SearchRequest& request_;
  const Motion& motion_;
  const Cushion& cushion_;
  const Goal& goal_;
  bool tracing_;  ///< only the shape matters: the ball passes the target, and an account is kept of the speed
  bool stop_;
  bool at_start_;  ///< so far the ball has touched only what it touches at the start
  SequenceCheck check_;
  Simulator<double, Motion, Cushion> sim_;
  std::optional<Line> first_jaw_{};
  double closest_ = 0;  ///< s into the arc
  Trace out_;
  ShotPath& path_ = out_.replay.path;
};

}  // namespace

void SpeedAccount::add(const Arc<double>& arc, double t) {
  const double now2 = dot(arc.velocity, arc.velocity);
  gain *= now2 / before2_;
  loss *= now2 / before2_;
  before2_ = now2;
  if (t > 0) loss += 2 * deceleration_ * norm(arc.position(t) - arc.at);
}

Replay replay_to_target(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch,
                        const Goal& goal) {
  Replay r = with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    return Follower(request, motion, cushion, launch, goal, false).run().replay;
  });
  budget.charge(r.path.cushions.size());
  budget.work() += r.work;
  return r;
}

Replay replay(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Goal& goal) {
  Replay r = replay_to_target(request, budget, launch, goal);
  // In `ideal` no ball comes to rest, so every cue ball would fall in the end.
  const bool may_scratch = request.problem->whole && !request.puzzle().table.pockets.empty();
  if (r.made && goal.counts && may_scratch && !is_ideal(request.puzzle().physics) &&
      !ending_of(request, budget, launch, r).cue_rests()) {
    r.made = false;
    r.failure = {FailureReason::scratched};
  }
  return r;
}

Trace trace(const SearchRequest& request, EvaluationBudget& budget, double angle, const Goal& goal) {
  const Mirror mirror{restitution(request.puzzle().physics)};
  Trace t = Follower(request, Ideal{}, mirror, {1, angle}, goal, true).run();
  budget.charge(t.replay.path.cushions.size());
  budget.work() += t.replay.work;
  return t;
}

}  // namespace bankshot::planning
