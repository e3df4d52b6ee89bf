// SPDX-License-Identifier: MIT
#include "support/traced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::test {
namespace {

using Number = Dual<4>;  ///< derivatives by the direction, the logarithm of the speed, and the place in diagonals

/// The meetings of a branch, and where each left the ball that goes on.
struct Path {
  Route route;
  std::vector<Vec2d> after;
};

/// Returns whether a ball leaves a cushion so slowly that the cushion may hold it, where a locked path goes through it,
/// and that the rounding of the bounce is multiplied.
bool is_held(const Boundary& boundary, const Record& bounce) {
  constexpr double slow = 0.01;
  const State<double>& s = bounce.state;
  const double all = norm(s.velocity) + boundary.body.radius * std::hypot(s.spin.x, s.spin.y, s.spin.z);
  return !(dot(boundary.normal(bounce.contact, s.at), s.velocity) > slow * all);
}

/// Returns whether two balls meet so slowly that their contact lasts, or as one of them touches a third.
bool is_more_than_a_meeting(const Trajectory& t, const Record& meeting) {
  constexpr double slow = 1e-3, instant = 1e-9;  // m/s, s
  const auto beside = [&](const Record& r) {
    return &r != &meeting && r.kind == EventKind::ball && std::abs(r.time - meeting.time) < instant;
  };
  return norm(meeting.state.velocity) + norm(meeting.other.velocity) < slow || std::ranges::any_of(t.events, beside);
}

/// Returns the branch of a simulated shot as far as a trace can follow it: up to a ball that moves already, to where a
/// cushion holds the ball, and to where contacts last. `most`: meetings.
Path branch_of(const Trajectory& t, const RouteBalls& balls, bool sends, std::size_t most) {
  Path path;
  std::vector<int> moved{0};
  int followed = 0;
  for (const Record& r : t.events) {
    if (path.route.size() == most) break;
    const bool bounce = r.kind == EventKind::cushion || r.kind == EventKind::jaw;
    if (bounce && r.ball == followed) {
      if (is_held(balls.boundary(followed), r)) break;
      path.route.push_back({followed, r.contact});
      path.after.push_back(r.state.at);
    }
    if (r.kind != EventKind::ball) continue;
    const int other = r.contact.index;
    const auto stood = [&](int ball) { return std::ranges::count(moved, ball) == 0; };
    const int met = r.ball == followed ? other : other == followed ? r.ball : -1;
    if (met < 0) {
      moved.push_back(r.ball);
      moved.push_back(other);
      continue;
    }
    if (!stood(met) || is_more_than_a_meeting(t, r)) break;
    moved.push_back(met);
    path.route.push_back({followed, Contact::ball(met)});
    if (sends) followed = met;
    path.after.push_back(r.ball == followed ? r.state.at : r.other.at);
  }
  return path;
}

/// Notes the place after each meeting.
struct Places {
  std::vector<State<Number>>& after;
  void operator()(const Arc<Number>&, const Number&) const {}
  void met(const State<Number>& state) const { after.push_back(state); }
};

}  // namespace

std::string differs_from_trace(const ShotRequest& shot, bool sends, std::size_t most, TraceTally& tally) {
  constexpr double near = 1e-6;  // m
  const Boundary cue(shot.table, shot.ball.body, shot.others);
  std::list<Boundary> own;
  std::vector<StandingBall> standing;
  for (std::size_t i = 0; i < shot.others.size(); ++i) {
    const int k = static_cast<int>(i) + 1;
    own.emplace_back(shot.table, shot.others[i].body, shot.others, std::array{k});
    standing.push_back({k, &own.back(), shot.others[i].at});
  }
  const RouteBalls balls(cue, standing, collisions(shot.physics), !sends);
  if (cue.clearance(shot.ball.at) < near) return "";  // a cushion may hold it from the start
  ShotRequest simulated = shot;
  if (shot.others.empty()) simulated.until.cushions = static_cast<int>(most);  // no more is compared
  const Path path = branch_of(simulate(simulated), balls, sends, most);
  const Vec2d v = direction(shot.launch.angle) * shot.launch.speed, turned = perpendicular(v);
  Vec2<Number> velocity{Number(v.x), Number(v.y)};
  velocity.x.v[0] = turned.x, velocity.x.v[1] = v.x;
  velocity.y.v[0] = turned.y, velocity.y.v[1] = v.y;
  State<Number> start = launched(shot.ball.at, shot.ball.body.radius, velocity, shot.spin);
  start.at.x.v[2] = start.at.y.v[3] = cue.diagonal;
  std::vector<State<Number>> after;
  const LockedEnd end = with_physics(shot.physics, [&](const auto& motion, const auto& cushion) {
    return follow_locked(balls, motion, cushion, std::span<const Meeting>(path.route), start, Places{after}).end;
  });
  ++tally.launches;
  if (end != LockedEnd::complete)
    return fmt::format("of {} meetings the trace has {}", path.route.size(), after.size());
  double steepest = cue.diagonal * (is_level(shot.physics) ? 1 : tolerance::pieces_rounding);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto& [at, going, spin] = after[i];
    const double turned_by = norm(value(going)) > 0 ? cue.diagonal / norm(value(going)) : 0;
    for (const int by : {0, 1, 2, 3})
      steepest = std::max(
          {steepest, std::hypot(at.x.v[by], at.y.v[by]), turned_by * std::hypot(going.x.v[by], going.y.v[by])});
    const double off = norm(value(at) - path.after[i]) / steepest;
    ++tally.meetings;
    tally.worst = std::max(tally.worst, off);
    if (!(off <= rounded_difference))
      return fmt::format("after meeting {} of {} the trace is {:.3g} m off, where {:.3g} m a radian are usual", i + 1,
                         path.route.size(), off * steepest, steepest);
  }
  return "";
}

std::string differs_from_discovery(const planning::SearchRequest& request, const Launch& launch, TraceTally& tally) {
  using namespace planning;
  EvaluationBudget budget(1000);
  Discovery path;
  discover(request, budget, launch, false, path);
  ++tally.launches;
  for (const Passage& p : path.passages) {
    const Branch branch{request, std::span(path.route).first(p.meetings), request.problem->aim_points[p.aim_point]};
    const auto traced = linearise(branch, budget, launch, true);
    if (!traced) return fmt::format("after {} meetings the trace does not get to its last leg", p.meetings);
    ++tally.meetings;
    for (const std::size_t k : {0, 1}) {
      const double steep = std::max({1.0, std::abs(p.linear.by[k][0]), std::abs(p.linear.by[k][1])});
      const double off = std::abs(traced->r[k] - p.linear.r[k]) / steep;
      tally.worst = std::max(tally.worst, off);
      if (!(off <= rounded_difference))
        return fmt::format("after {} meetings residual {} is {:.17g}, and that of the trace {:.17g}", p.meetings, k,
                           p.linear.r[k], traced->r[k]);
    }
  }
  return "";
}

}  // namespace bankshot::test
