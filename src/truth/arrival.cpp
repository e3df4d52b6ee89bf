// SPDX-License-Identifier: MIT
#include "truth/arrival.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/coefficients.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "truth/judge.hpp"
#include "truth/line_in.hpp"

namespace bankshot::truth {
namespace {

/// Largest delay of the fall on the same arc, relative to the time of arrival.
constexpr double same_fall = 1e-9;

/// Returns the goal that a shot claims to reach.
Goal goal_of(const Shot& claim, double slack = 0) {
  const int n = static_cast<int>(claim.path.cushions.size());
  return {n,    n, &claim.path.cushions, claim.path.then.empty() ? nullptr : &claim.path.then, claim.path.arrival.time,
          slack};
}

/// Returns the goal that the margin of a shot counts: its own cushions up to the first ball, then the puzzle's rules.
Goal counted(const Shot& claim) {
  const int n = static_cast<int>(claim.path.cushions.size());
  return {n, n, &claim.path.cushions, nullptr, claim.path.arrival.time, 0, &claim};
}

Path beside(Run run, double turned, double pushed) {
  run.turned = turned, run.pushed = pushed;
  return run_truth(run);
}

/// Returns true if both paths have the same contacts up to these events. Ends of arcs are ignored.
bool same_meetings(const Path& a, std::size_t last, const Path& b, std::size_t its_last) {
  if (a.events.size() <= last || b.events.size() <= its_last) return false;
  const auto next = [](const Path& path, std::size_t i, std::size_t end) {
    while (i < end && path.events[i].kind == EventKind::slide_to_roll) ++i;
    return i;
  };
  for (std::size_t i = 0, k = 0;; ++i, ++k) {
    i = next(a, i, last), k = next(b, k, its_last);
    if (a.events[i].kind != b.events[k].kind || a.events[i].contact != b.events[k].contact) return false;
    if (i == last || k == its_last) return i == last && k == its_last;
  }
}

/// Returns the event at the end of the arriving arc: after n bounces, the one nearest to the claimed time.
std::size_t arriving(const Path& path, int n, double time, bool stops) {
  std::optional<std::size_t> best;
  const auto late = [&](std::size_t i) {
    return std::abs((stops ? path.events[i].time : path.events[i].passing.time) - time);
  };
  int bounces = 0;
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    if (bounces == n && (!best || late(i) < late(*best))) best = i;
    bounces += path.events[i].kind == EventKind::cushion;
  }
  return best.value_or(path.events.size());
}

/// Returns the second contact of the cue ball with a ball, for caroms.
std::size_t second_contact(const Path& path) {
  int contacts = 0;
  const auto second = [&](const TruthEvent& e) {
    contacts += e.kind == EventKind::ball && e.ball == 0;
    return contacts == 2;
  };
  return static_cast<std::size_t>(std::ranges::find_if(path.events, second) - path.events.begin());
}

/// Returns the event that ends the arriving arc of an object ball after `n` bounces. If it falls, that is the last arc;
/// if it must rest, the event is its rest. Bounces are counted because the arcs before and after one are equally near
/// in time but lead elsewhere.
std::size_t arriving_of(const Path& path, int ball, int n, double time, bool stops) {
  const auto falls = [&](const TruthEvent& e) { return e.ball == ball && e.kind == EventKind::pocket; };
  const auto fall = std::ranges::find_if(path.events, falls);
  if (fall != path.events.end() && fall != path.events.begin() && fall->time - time <= same_fall * (1 + time))
    return static_cast<std::size_t>(fall - path.events.begin()) - 1;
  std::optional<std::size_t> best;
  const auto late = [&](std::size_t i) {
    return std::abs((stops ? path.events[i].time : path.events[i].passing.time) - time);
  };
  int bounces = 0;
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    const TruthEvent& e = path.events[i];
    if (e.ball != ball) continue;
    const bool its = stops ? e.kind == EventKind::rest : e.kind == EventKind::slide_to_roll && bounces == n;
    if (its && (!best || late(i) < late(*best))) best = i;
    bounces += e.kind == EventKind::cushion;
  }
  return best.value_or(path.events.size());
}

/// Returns the metres between two arrivals: between points of rest, or across the line of travel.
double apart(const TruthEvent& a, const TruthEvent& b, bool stops) {
  if (stops) return norm((a.state.at - b.state.at) + (a.at_rest - b.at_rest));
  return std::abs((a.passing.lateral - b.passing.lateral) + (a.passing.lateral_rest - b.passing.lateral_rest));
}

}  // namespace

Scene::Scene(const Puzzle& p) : puzzle(p), boundary(p.table, p.ball.body, p.others), physics_(refined(p.physics)) {
  const auto asked = arrival_range(p);
  stops = point_of(p.target) && asked && asked->high == 0;
  if (!goes_on_after_contact(p.target)) return;
  all_ = {{}, p.table, p.physics, p.ball, p.others, {}, {}, {}};
  for (int k = 1; k <= static_cast<int>(p.others.size()); ++k)
    others_.emplace_back(p.table, p.others[static_cast<std::size_t>(k) - 1].body, p.others, std::array{k});
}

Run Scene::run(const Launch& launch, const LaunchSpin& spin, int cushions) const {
  Run r{boundary, physics_,
        launched(puzzle.ball.at, puzzle.ball.body.radius, direction(launch.angle) * launch.speed, spin), cushions + 1,
        4L * cushions + 100};
  if (const PointTarget* const point = point_of(puzzle.target)) r.target = point->at;
  if (all_) r.all = &*all_;
  const Then* const then = then_of(puzzle.target);
  r.sends = then ? 1 + static_cast<int>(then->links.size()) : 0;
  return r;
}

const Boundary& Scene::boundary_of(int ball) const {
  return ball == 0 ? boundary : *std::next(others_.begin(), ball - 1);
}

double Scene::miss(const Arrived& there) const {
  if (!there.taken_by) return there.passed;
  const Circle& rim = *boundary_of(there.ball).rim(there.taken_by);
  if (const BallTarget* const touch = touch_of(puzzle.target))
    return std::abs(there.offset + rim.radius * std::sin(touch->exact_cut()));
  return std::abs(there.offset - exact_offset(boundary_of(there.ball), rim, there.heading, there.offset));
}

Arrived Scene::replay(const Launch& launch, const Shot& claim, double slack) const {
  const int n = static_cast<int>(claim.path.cushions.size());
  return judge(*this, run_truth(run(launch, claim.spin, n)), goal_of(claim, slack));
}

/// Returns the relative error that rounding of the position causes in the speed at the slowest bounce, for a ball that
/// creeps up to a cushion. The derivatives have the same relative error.
double Scene::creeping(const Path& path, std::size_t arrives) const {
  const double moved2 = 2 * deceleration(puzzle.physics) * tolerance::simulation_error * 0x1p-53 * boundary.extent;
  double most = 0;
  for (std::size_t i = 0; i < arrives && i < path.events.size(); ++i)
    if (const TruthEvent& e = path.events[i]; e.kind == EventKind::cushion && norm(e.state.velocity) > 0)
      most = std::max(most, moved2 / dot(e.state.velocity, e.state.velocity));
  return most;
}

std::optional<Scene::Condition> Scene::condition(const Shot& shot, const Sides& sides) const {
  constexpr double step = 1e-14;  // the truncation error is of this size; the values have 32 digits
  const int n = static_cast<int>(shot.path.cushions.size());
  Run base = run(shot.launch, shot.spin, n);
  if (!stops) base.target = shot.path.arrival.at;
  const auto arrives_in = [&](const Path& path) {
    if (first_of_carom(puzzle.target) != 0) return second_contact(path);
    if (shot.path.then.empty()) return arriving(path, n, shot.path.arrival.time, stops);
    const int bounces = static_cast<int>(shot.path.then.back().cushions.size());
    return arriving_of(path, shot.arriving(), bounces, shot.path.arrival.time, stops);
  };
  const Path path = run_truth(base);
  const auto moved = [&](double turned, double pushed) -> std::optional<double> {
    // On one side of the shot the path may meet other cushions.
    for (const double side : {step, -step}) {
      const Path from = sides.beyond ? beside(base, side * turned, side * pushed) : path;
      const double to = sides.beyond ? 2 * side : side;
      const Path other = beside(base, to * turned, to * pushed);
      const std::size_t its = arrives_in(from), others = arrives_in(other);
      if (same_meetings(from, its, other, others)) return apart(other.events[others], from.events[its], stops) / step;
    }
    return {};
  };
  const auto by_aim = moved(sides.aim, 0), by_speed = moved(0, sides.speed);
  if (!by_aim || !by_speed) return {};
  return Condition{std::max(*by_aim, *by_speed), creeping(path, arrives_in(path))};
}

Run Scene::in_double(const Launch& launch, const LaunchSpin& spin, int cushions) const {
  const Run r = run(launch, spin, cushions);
  return {boundary, puzzle.physics, r.start, r.cushions, r.events, r.target, 0, 0, forever, r.all, r.sends};
}

bool Scene::counts(const Launch& launch, const Shot& claim) const {
  if (!(launch.speed > 0)) return false;
  const int n = static_cast<int>(claim.path.cushions.size());
  return judge(*this, run_truth(run(launch, claim.spin, n)), counted(claim)).made() && !scratches(launch, claim.spin);
}

bool Scene::seems_to_count(const Launch& launch, const Shot& claim) const {
  if (!(launch.speed > 0)) return false;
  const int n = static_cast<int>(claim.path.cushions.size());
  return judge(*this, run_double(in_double(launch, claim.spin, n)), counted(claim)).made() &&
         !scratches(launch, claim.spin);
}

/// Scratches do not count in `ideal` physics, where no ball comes to rest and the cue ball would usually fall in the
/// end.
bool Scene::may_scratch() const {
  return is_ball(puzzle.target) && !puzzle.table.pockets.empty() && !is_ideal(puzzle.physics);
}

bool Scene::scratches(const Launch& launch, const LaunchSpin& spin) const {
  if (!may_scratch()) return false;
  const Starts starts({.table = puzzle.table,
                       .physics = puzzle.physics,
                       .ball = puzzle.ball,
                       .others = puzzle.others,
                       .launch = launch,
                       .spin = spin});
  const long most = max_events;
  return with_physics(puzzle.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(starts.balls(), motion, cushion, collisions(puzzle.physics));
    for (long i = 0; i < most && sim.in_play(0); ++i)
      if (sim.step().event.kind == EventKind::horizon) break;
    return !sim.in_play(0);
  });
}

double Scene::chance(const Shot& shot, int draws) const {
  std::mt19937_64 engine(static_cast<std::uint64_t>(draws));
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const CushionRule& rule = puzzle.cushions;
  const auto* const sequence = rule.sequence ? &*rule.sequence : nullptr;
  const Goal goal{rule.min, rule.max, sequence, nullptr, shot.path.arrival.time, 0, &shot};
  const DrawnPhysics physics(puzzle.physics);
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    const double size = std::sqrt(-2 * std::log(uniform())), turn = radians(360) * uniform();  // Box and Muller
    const Launch l{shot.launch.speed + puzzle.noise.speed_at(shot.launch.speed) * size * std::cos(turn),
                   wrap_angle(shot.launch.angle + puzzle.noise.angle * size * std::sin(turn))};
    if (!(l.speed > 0)) continue;
    const auto made_on = [&](const Scene& scene, const LaunchSpin& spin) {
      made += judge(scene, run_double(scene.in_double(l, spin, rule.max)), goal).made() && !scene.scratches(l, spin);
    };
    if (!puzzle.errs_in_more()) {
      made_on(*this, shot.spin);
      continue;
    }
    const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(radians(360) * uniform()); };
    LaunchSpin spin = shot.spin;
    spin.side += puzzle.noise.side_of(puzzle.ball.body.radius) * normal();
    spin.top += puzzle.noise.top_of(puzzle.ball.body.radius) * normal();
    Puzzle moved = puzzle;
    const auto move = [&](Vec2d& at) { at += Vec2d{normal(), normal()} * puzzle.noise.at; };
    move(moved.ball.at);
    for (Ball& other : moved.others) move(other.at);
    std::vector<double> off(physics.count());
    for (double& z : off) z = normal();
    if (physics.count() > 0) moved.physics = physics.draw(off.data(), moved.ball.body);
    puzzle.noise.at > 0 || physics.count() > 0 ? made_on(Scene(moved), spin) : made_on(*this, spin);
  }
  return static_cast<double>(made) / draws;
}

}  // namespace bankshot::truth
