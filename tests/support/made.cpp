// SPDX-License-Identifier: MIT
#include "support/made.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/motion/launched.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/drop.hpp"
#include "support/truth.hpp"

namespace bankshot::test {

bool through_corner(const Made& made, double beside) {
  const auto sequence = [&](double turned) {
    ShotRequest r{.table = made.puzzle.table,
                  .physics = made.puzzle.physics,
                  .ball = made.puzzle.ball,
                  .launch = made.launch,
                  .spin = made.puzzle.spin};
    r.launch.angle = wrap_angle(r.launch.angle + turned);
    r.until.cushions = made.bounces + 1;
    std::vector<Contact> s = simulate(r).sequence();
    s.resize(std::min(s.size(), static_cast<std::size_t>(made.bounces)));
    return s;
  };
  return sequence(-beside) != sequence(0) || sequence(beside) != sequence(0);
}

namespace {

double kappa(const Made& made) {
  const Puzzle& p = made.puzzle;
  const Boundary boundary(p.table, p.ball.body);
  const State<double> start =
      launched(p.ball.at, p.ball.body.radius, direction(made.launch.angle) * made.launch.speed, p.spin);
  return condition({.boundary = boundary, .physics = p.physics, .start = start, .cushions = made.bounces + 1}).kappa;
}

}  // namespace

bool is_hard(const Made& made) {
  constexpr double steep = 1e6, margin = 1e-9;
  return kappa(made) >= steep || through_corner(made, margin);
}

bool is_exact(const Made& made) {
  const BallTarget* const touch = touch_of(made.puzzle.target);
  if (touch && touch->within >= any_touch) return false;  // any touch makes it
  if (!is_pocket(made.puzzle.target)) return true;
  if (then_of(made.puzzle.target)) return false;  // the last drop is as it fell, rarely on the exact line
  const Puzzle& p = made.puzzle;
  const Trajectory t =
      simulate({.table = p.table, .physics = p.physics, .ball = p.ball, .launch = made.launch, .spin = p.spin});
  if (t.end != EventKind::pocket) return false;
  const Record& drop = t.events[t.events.size() - 2];
  constexpr double exact = 1e-11;  // fraction of the diagonal
  return std::abs(left_of_drop(Boundary(p.table, p.ball.body), drop.contact, drop.state.at, drop.state.velocity)) <
         exact * p.table.diagonal();
}

bool nothing_free(const Made& made) {
  const auto arrival = arrival_range(made.puzzle);
  return !made.puzzle.spin_range && !is_ideal(made.puzzle.physics) && (!arrival || arrival->fixed()) && is_exact(made);
}

bool is_among(const Launch& launch, const std::vector<Shot>& shots) {
  constexpr double same = 1e-5;  // rad, and fraction of the speed; closer roots count as one here
  return std::any_of(shots.begin(), shots.end(), [&](const Shot& s) {
    const double turned = wrap_angle(s.launch.angle - launch.angle + radians(180)) - radians(180);
    return std::abs(turned) < same && std::abs(s.launch.speed / launch.speed - 1) < same;
  });
}

}  // namespace bankshot::test
