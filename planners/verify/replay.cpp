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

  Trace run(std::vector<Contact>* contacts) {
    Trace out = follow(contacts);
    out.replay.work += sim_.work();
    return out;
  }

 private:
  Trace follow(std::vector<Contact>* contacts) {
    for (;;) {
      bool arrived = false;  // on a piece before the last
      const Event e = sim_.step(
          forever, [&](const Arc<double>&, double) { arrived = arrived || look_along_arc(EventKind::slide_to_roll); });
      if (arrived || look_along_arc(e.kind)) return out_;
      if (tracing_) {
        out_.account.add(sim_.arc(), sim_.travelled());
        if (out_.account.beyond(request_.speed.high)) return fail(FailureReason::too_long);
      }
      switch (e.kind) {
        case EventKind::cushion:
          if (bounces_in_place()) return fail(FailureReason::in_place, e.contact);
          if (k_ == goal_.max) return fail(FailureReason::extra_cushion, e.contact);
          if (!check_.accepts(k_, e)) return fail(FailureReason::wrong_cushion, e.contact);
          ++k_;
          if (!std::is_same_v<Cushion, Mirror> && !(dot(sim_.normal(e.contact), sim_.state().velocity) > 0))
            out_.replay.cushion_stick = true;
          if (contacts) contacts->push_back(e.contact);
          if (out_.replay.touches_jaws) out_.replay.met.push_back(e.contact);
          break;
        case EventKind::jaw:
          if (!out_.replay.touches_jaws && contacts) out_.replay.met = *contacts;
          out_.replay.met.push_back(e.contact);
          touch_jaw(e.contact);
          break;
        case EventKind::slide_to_roll:
          break;
        case EventKind::ball:
          if (!request_.problem->objects) return taken(e.contact);
          if (const auto* chain = request_.problem->objects->chain_by(e.contact.index);
              chain && may_set_going(e.contact))
            return set_going(*chain, contacts);
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

  bool counts() const { return k_ >= goal_.min && !check_.open(); }
  /// Returns whether the ball bounces where it stands. Legs have a length, except that between the two cushions of a
  /// corner.
  bool bounces_in_place() {
    constexpr int of_a_corner = 2;
    at_start_ = at_start_ && norm(sim_.state().at - request_.puzzle().ball.at) <= request_.problem->boundary.touch;
    return at_start_ && (request_.problem->in_vertex() || k_ == of_a_corner);
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
      out_.replay.arrival = {sim_.time() - arc.seconds(sim_.travelled()) + arc.seconds(t), norm(there.velocity),
                             there.at};
    }
    return miss;
  }

  bool arrive_in_passing() {
    if (tracing_) out_.account.add(sim_.arc(), closest_);
    out_.replay.made = true;
    out_.replay.bounces = k_;
    return true;
  }

  Trace taken(Contact by) {
    const State<double>& now = sim_.state();
    const AimPoint* const aim_point = counts() ? request_.problem->aim_point_taken_by(by, now.at) : nullptr;
    if (!aim_point || !goal_.allows(request_, *aim_point))
      return fail(by.kind == ContactKind::pocket ? FailureReason::pocketed : FailureReason::hit_ball, by);
    out_.replay.made = true;
    out_.replay.bounces = k_;
    // A ball that stops on the pocket's circle keeps the direction of its last arc.
    const Vec2d heading = norm(now.velocity) > 0 ? now.velocity : sim_.arc().velocity;
    out_.replay.arrival = {sim_.time(), norm(now.velocity), now.at};
    if (aim_point->cuts) {
      out_.replay.hits.push_back(
          hit_by({now.at, heading}, norm(now.velocity), by.index, aim_point->at, aim_point->reach, k_));
      touched(*aim_point, {now.at, heading}, out_.replay);
      return out_;
    }
    measure(request_, *aim_point, first_jaw_ ? *first_jaw_ : Line{now.at, heading}, out_.replay);
    return out_;
  }

  /// Continues after the cue ball has touched the first ball of a chain; those balls do the rest.
  Trace set_going(const Objects::Chain& chain, std::vector<Contact>* contacts) {
    out_.replay.bounces = k_;
    out_.replay.miss = std::numeric_limits<double>::infinity();
    SetGoing(request_, motion_, cushion_, chain, goal_, {k_, check_}, contacts, out_.replay)
        .run(sim_.state(), sim_.time());
    return out_;
  }

  /// Counts a jaw contact. The first jaw met at a target pocket defines the line of travel there.
  void touch_jaw(Contact jaw) {
    const auto of_jaws = [&](const AimPoint& aim_point) { return aim_point.taken_by.index == jaw.jaw_pocket(); };
    if (!first_jaw_ && std::ranges::any_of(request_.problem->aim_points, of_jaws))
      first_jaw_ = Line{sim_.state().at, sim_.on_arc(sim_.travelled()).velocity};
    out_.replay.touches_jaws = true;
    ++out_.replay.jaws;
  }

  Trace rest() {
    if (!stop_ || request_.problem->objects || !counts()) return fail(FailureReason::fell_short);
    const AimPoint& aim_point = request_.problem->nearest_aim_point(sim_.state().at);
    out_.replay.miss = norm(sim_.state().at - aim_point.at);
    out_.replay.arrival = {sim_.time(), 0, sim_.state().at};
    out_.replay.bounces = k_;
    out_.replay.made = out_.replay.miss <= aim_point.reach;
    if (!out_.replay.made) out_.replay.failure = {FailureReason::missed};
    return out_;
  }

  /// Returns the distance [m] of the cue ball from the aim point; if an object ball is to go there, the way through
  /// that ball.
  double apart(const AimPoint& m) const {
    if (m.ball == 0) return norm(sim_.state().at - m.at);
    const Vec2d at = request_.problem->objects->find(m.ball).at_rest.at;
    return norm(sim_.state().at - at) + norm(at - m.at);
  }

  Trace fail(FailureReason reason, Contact contact = {}) {
    // If the ball passed the target after the bounces asked, the miss is known; otherwise it is the distance when the
    // shot failed.
    if (!(out_.replay.miss < std::numeric_limits<double>::infinity())) {
      for (const AimPoint& m : request_.problem->aim_points) out_.replay.miss = std::min(out_.replay.miss, apart(m));
      out_.replay.arrival = {sim_.time(), norm(sim_.state().velocity), sim_.state().at};
    } else if (reason == FailureReason::extra_cushion) {
      reason = FailureReason::missed;
      contact = {};
    }
    out_.replay.failure = {reason, contact};
    out_.replay.bounces = k_;
    return out_;
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
  int k_ = 0;
  std::optional<Line> first_jaw_{};
  double closest_ = 0;  ///< s into the arc
  Trace out_;
};

}  // namespace

void SpeedAccount::add(const Arc<double>& arc, double t) {
  const double now2 = dot(arc.velocity, arc.velocity);
  gain *= now2 / before2_;
  loss *= now2 / before2_;
  before2_ = now2;
  if (t > 0) loss += 2 * deceleration_ * norm(arc.position(t) - arc.at);
}

Replay replay_to_target(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Goal& goal,
                        std::vector<Contact>* contacts) {
  Replay r = with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    return Follower(request, motion, cushion, launch, goal, false).run(contacts).replay;
  });
  budget.charge(static_cast<std::size_t>(r.bounces));
  budget.work() += r.work;
  return r;
}

Replay replay(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Goal& goal,
              std::vector<Contact>* contacts) {
  Replay r = replay_to_target(request, budget, launch, goal, contacts);
  // In `ideal` no ball comes to rest, so every cue ball would fall in the end.
  const bool may_scratch = request.problem->whole && !request.puzzle().table.pockets.empty();
  if (r.made && goal.counts && may_scratch && !is_ideal(request.puzzle().physics) &&
      !ending_of(request, budget, launch, r).cue_rests()) {
    r.made = false;
    r.failure = {FailureReason::scratched};
  }
  return r;
}

Trace trace(const SearchRequest& request, EvaluationBudget& budget, double angle, const Goal& goal,
            std::vector<Contact>* contacts) {
  const Mirror mirror{restitution(request.puzzle().physics)};
  Trace t = Follower(request, Ideal{}, mirror, {1, angle}, goal, true).run(contacts);
  budget.charge(static_cast<std::size_t>(t.replay.bounces));
  budget.work() += t.replay.work;
  return t;
}

}  // namespace bankshot::planning
