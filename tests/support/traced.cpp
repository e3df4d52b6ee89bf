// SPDX-License-Identifier: MIT
#include "support/traced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <span>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/trace/discover.hpp"

namespace bankshot::test {
namespace {

/// Derivatives by the direction, the logarithm of the speed, the place in diagonals, and the spin in launch speeds.
constexpr std::size_t numbers = 7;
using Number = Dual<numbers>;

constexpr double near = 1e-6;  // m; balls and cushions that are so near may touch

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

/// Returns whether rounding decides if a ball rolls or slides.
bool nearly_rolls(const State<double>& s, double radius) {
  constexpr double least = 2e-16, most = 1e-13;
  const double slip = norm(SlideRollOf<double>::slip({.radius = radius}, s));
  const double all = norm(s.velocity) + radius * std::hypot(s.spin.x, s.spin.y, s.spin.z);
  return slip > least * all && slip < most * all;
}

/// Returns whether two balls part so slowly that their contact may last, or meet as one of them touches a third.
/// `stand`: balls at rest besides these two.
bool is_more_than_a_meeting(const Trajectory& t, const Record& meeting, const std::vector<Ball>& stand,
                            std::span<const Body> bodies) {
  constexpr double slow = 0.01, instant = 1e-9;  // of the speeds, s
  const auto beside = [&](const Record& r) {
    return &r != &meeting && r.kind == EventKind::ball && std::abs(r.time - meeting.time) < instant;
  };
  const State<double>&a = meeting.state, &b = meeting.other;
  const Vec2d line = (b.at - a.at) / norm(b.at - a.at);
  const bool lasts = !(dot(line, b.velocity - a.velocity) > slow * (norm(a.velocity) + norm(b.velocity)));
  const auto touched = [&](const Ball& third) {
    const auto by = [&](const State<double>& one, const Body& body) {
      return norm(third.at - one.at) < touching_distance(third.body, body) + near;
    };
    return by(a, bodies[0]) || by(b, bodies[1]);
  };
  return lasts || std::ranges::any_of(t.events, beside) || std::ranges::any_of(stand, touched);
}

/// Returns the branch of a simulated shot as far as a trace can follow it: up to a ball that moves already, to where a
/// cushion holds the ball, and to where contacts last. `most`: meetings.
Path branch_of(const Trajectory& t, const ShotRequest& shot, const RouteBalls& balls, bool sends, std::size_t most) {
  Path path;
  std::vector<int> moved{0};
  int followed = 0;
  const auto body_of = [&](int ball) { return balls.boundary(ball).body; };
  for (const Record& r : t.events) {
    if (path.route.size() == most || (r.ball == followed && nearly_rolls(r.state, body_of(followed).radius))) break;
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
    std::vector<Ball> stand;
    for (std::size_t k = 0; k < shot.others.size(); ++k)
      if (const int ball = static_cast<int>(k) + 1; ball != met && stood(ball)) stand.push_back(shot.others[k]);
    if (!stood(met) || is_more_than_a_meeting(t, r, stand, std::array{body_of(r.ball), body_of(other)})) break;
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
  const Path path = branch_of(simulate(simulated), shot, balls, sends, most);
  const Vec2d v = direction(shot.launch.angle) * shot.launch.speed, turned = perpendicular(v);
  Vec2<Number> velocity{Number(v.x), Number(v.y)};
  velocity.x.v[0] = turned.x, velocity.x.v[1] = v.x;
  velocity.y.v[0] = turned.y, velocity.y.v[1] = v.y;
  State<Number> start = launched(shot.ball.at, shot.ball.body.radius, velocity, shot.spin);
  start.at.x.v[2] = start.at.y.v[3] = cue.diagonal;
  start.spin.x.v[4] = start.spin.y.v[5] = start.spin.z.v[6] = shot.launch.speed / shot.ball.body.radius;
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
    for (std::size_t by = 0; by < numbers; ++by)
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
