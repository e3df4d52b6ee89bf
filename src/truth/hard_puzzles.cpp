// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "bankshot/simulate/trajectory.hpp"
#include "truth/hard_cases.hpp"

namespace bankshot::truth {
namespace {

constexpr double R = 0.028575;
using Puzzles = std::vector<Puzzle>;

Puzzle to_point(Vec2d at, int cushions, const Physics& physics, Range arrive) {
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = physics,
           .ball = {{0.6, 0.35}, R, 0.17},
           .target = PointTarget{at},
           .cushions = CushionRule::exactly(cushions)};
  if (!is_ideal(physics)) p.arrive = arrive;
  return p;
}

Puzzles on_cushions() {
  Puzzles out;
  for (const Physics& physics : {ideal_physics(), rolling_physics(), spin_physics({R})})
    for (const Vec2d& target : {Vec2d{1.3, R}, Vec2d{2 - R, 0.6}, Vec2d{0.4, 1 - R}, Vec2d{2 - R, 1 - R}, Vec2d{R, R}})
      for (const int cushions : {0, 1}) out.push_back(to_point(target, cushions, physics, {0.3, 0.3}));
  for (const Vec2d& target : {Vec2d{1.3, R}, Vec2d{0.4, 1 - R}, Vec2d{2 - R, 1 - R}})
    out.push_back(to_point(target, 0, rolling_physics(), {0, 0}));
  for (const Vec2d& target : {Vec2d{1.3, R}, Vec2d{0.4, 1 - R}})
    out.push_back(to_point(target, 0, spin_physics({R}), {0, 0}));
  return out;
}

Puzzles at_the_start() {
  Puzzles out;
  for (const Physics& physics : {ideal_physics(), rolling_physics(), spin_physics({R})})
    for (const int cushions : {1, 2}) out.push_back(to_point({0.6, 0.35}, cushions, physics, {0.3, 0.3}));
  return out;
}

/// Targets at the reach of the top speed: v²/(2 μr g) for a rolling ball, 12 v²/(49 μs g) + (5v/7)²/(2 μr g) for a
/// centre hit.
Puzzles at_the_speed_bound() {
  Puzzles out;
  const double v = 0.4;
  for (const Physics& physics : {rolling_physics(), spin_physics({R})})
    for (const double share : {1.0, 1 - 1e-15, 1 - 1e-12, 0.5}) {
      const double reach = is_straight(physics) ? v * v / (2 * 0.01 * 9.81)
                                                : 12 * v * v / (49 * 0.2 * 9.81) + 25 * v * v / 49 / (2 * 0.01 * 9.81);
      const Vec2d from{0.3, 0.3}, direction_{0.8, 0.6};
      out.push_back({.table = rectangle_table(2, 1),
                     .physics = physics,
                     .ball = {from, R, 0.17},
                     .target = PointTarget{from + direction_ * (reach * share), 1e-9},
                     .cushions = CushionRule::exactly(0),
                     .arrive = Range{0, 0},
                     .speed = {0.1, v}});
    }
  return out;
}

struct Fold {
  double side, restitution, speed, from, to;  ///< aims in degrees
};

ShotRequest launch(const Fold& c, double degrees_) {
  ShotRequest shot = spin_shot({0.5, 0.3}, c.speed, degrees_, {.side = c.side});
  std::get<UsualCushion>(shot.physics.cushion).restitution = Restitution{c.restitution};
  std::get<SlideRoll>(shot.physics.motion).rolling_friction = 0.05;
  return shot;
}

struct Rest {
  Vec2d at;
  double determinant;  ///< determinant of d(rest)/d(aim, ln speed)
  std::vector<Contact> met;
};

Rest rest_of(const ShotRequest& shot) {
  const Boundary boundary(shot.table, shot.ball.body);
  const State<double> s = start_state(shot);
  const Run run{boundary, shot.physics, s};
  const Condition c = condition(run);
  const Trajectory t = simulate(shot);
  // The spin turns and grows together with the velocity.
  const double by_aim[] = {0, 0, -s.velocity.y, s.velocity.x, -s.spin.y, s.spin.x, 0};
  const double by_speed[] = {0, 0, s.velocity.x, s.velocity.y, s.spin.x, s.spin.y, s.spin.z};
  double m[2][2] = {};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 7; ++k) m[i][0] += c.jacobian[i][k] * by_aim[k], m[i][1] += c.jacobian[i][k] * by_speed[k];
  return {t.events.back().state.at, m[0][0] * m[1][1] - m[0][1] * m[1][0], t.sequence()};
}

/// Finds an aim at which the determinant vanishes while the cushions stay the same. Returns false if the scan finds
/// none.
bool find_fold(const Fold& c, double& aim) {
  constexpr double step = 0.25;
  for (double low = c.from; low < c.to; low += step) {
    const Rest a = rest_of(launch(c, low)), b = rest_of(launch(c, low + step));
    if (a.met != b.met || a.determinant * b.determinant >= 0) continue;
    double l = low, h = low + step;
    for (int i = 0; i < 60; ++i) {
      const double mid = (l + h) / 2;
      (rest_of(launch(c, mid)).determinant * a.determinant > 0 ? l : h) = mid;
    }
    const double scale = std::abs(a.determinant) + std::abs(b.determinant);
    if (std::abs(rest_of(launch(c, l)).determinant) > 1e-6 * scale) continue;  // a jump, not a root
    aim = l;
    return true;
  }
  return false;
}

/// Points of rest where d(rest)/d(aim, speed) is singular, found by bisection of its determinant along a line of
/// launches.
Puzzles folds() {
  Puzzles out;
  for (const Fold& c : {Fold{0, 0.5, 1.6, 345, 352},
                        {0, 0.5, 2, 345, 352},
                        {0, 0.5, 2.5, 345, 352},
                        {1, 0.85, 2, 20, 28},
                        {2, 0.85, 2, 20, 28},
                        {2, 0.85, 2.5, 20, 28},
                        {0, 0.85, 3, 184, 190}}) {
    double aim = 0;
    if (!find_fold(c, aim)) continue;
    const ShotRequest shot = launch(c, aim);
    const Rest rest = rest_of(shot);
    out.push_back({.table = shot.table,
                   .physics = shot.physics,
                   .ball = shot.ball,
                   .spin = shot.spin,
                   .target = PointTarget{rest.at, 1e-3},
                   .cushions = CushionRule::in_order(rest.met),
                   .arrive = Range{0, 0},
                   .speed = {0.1, 10}});
  }
  return out;
}

struct Class {
  std::string_view name;
  Puzzles (*puzzles)();
};

constexpr Class classes[] = {{"targets on cushions", on_cushions},
                             {"target at the start", at_the_start},
                             {"edge of the speed bound", at_the_speed_bound},
                             {"folds", folds}};

}  // namespace

std::vector<std::string_view> hard_puzzle_classes() {
  std::vector<std::string_view> names;
  for (const Class& c : classes) names.push_back(c.name);
  return names;
}

Puzzles hard_puzzles(std::string_view name) {
  for (const Class& c : classes)
    if (c.name == name) return c.puzzles();
  throw std::invalid_argument(fmt::format("\"{}\" is no class of hard puzzles", name));
}

}  // namespace bankshot::truth
