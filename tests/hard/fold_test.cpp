// SPDX-License-Identifier: MIT
//
// Folds. Why hard: with massé or side the place of rest as a function of (aim, speed) folds over: at the fold the Jacobian
// is singular, two roots merge, and beyond it there is none. Newton's method halves its error a step there instead
// of squaring it, and an error δ of the place is √δ of the launch: half of the digits. Asserted: at the fold and just
// inside it an answer is found and replays to 1e-9 of the diagonal. The fold is found here by bisection of the
// determinant of dual numbers along a line of launches.
#include "bankshot/plan/planner.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

struct Class {
  double side, restitution, speed, from, to;  ///< aims in degrees
};

ShotRequest launch(const Class& c, double degrees_) {
  ShotRequest shot = spin_shot({0.5, 0.3}, c.speed, degrees_, {.side = c.side});
  std::get<Han2005>(shot.physics.cushion).restitution = Restitution{c.restitution};
  std::get<SlideRoll>(shot.physics.motion).rolling_friction = 0.05;
  return shot;
}

struct Rest {
  Vec2d at;
  double determinant;  ///< of d(rest)/d(aim, ln speed)
  std::vector<int> met;
};

Rest rest_of(const ShotRequest& shot) {
  const Boundary boundary(shot.table, shot.ball.radius);
  const State<double> s = start_state(shot);
  const Run run{boundary, shot.physics, s};
  const Condition c = condition(run);
  const Trajectory t = simulate(shot);
  // The spin turns and grows with the velocity.
  const double by_aim[] = {0, 0, -s.velocity.y, s.velocity.x, -s.spin.y, s.spin.x, 0};
  const double by_speed[] = {0, 0, s.velocity.x, s.velocity.y, s.spin.x, s.spin.y, s.spin.z};
  double m[2][2] = {};
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 7; ++k) m[i][0] += c.jacobian[i][k] * by_aim[k], m[i][1] += c.jacobian[i][k] * by_speed[k];
  return {t.events.back().state.at, m[0][0] * m[1][1] - m[0][1] * m[1][0], t.sequence()};
}

/// An aim at which the determinant vanishes while the cushions stay the same; none when the scan finds none.
bool find_fold(const Class& c, double& aim) {
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

}  // namespace

TEST_CASE("a place of rest on a fold of the map is reached") {
  int folds = 0;
  for (const Class& c : {Class{0, 0.5, 1.6, 345, 352},
                         {0, 0.5, 2, 345, 352},
                         {0, 0.5, 2.5, 345, 352},
                         {1, 0.85, 2, 20, 28},
                         {2, 0.85, 2, 20, 28},
                         {2, 0.85, 2.5, 20, 28},
                         {0, 0.85, 3, 184, 190}}) {
    double aim = 0;
    if (!find_fold(c, aim)) continue;
    ++folds;
    const ShotRequest shot = launch(c, aim);
    const Rest rest = rest_of(shot);
    Puzzle p{.table = shot.table, .physics = shot.physics, .ball = shot.ball, .spin = shot.spin, .target = PointTarget{rest.at, 1e-3},
             .cushions = CushionRule::in_order(rest.met), .arrive = Range{0, 0}, .speed = {0.1, 10}};
    const Answer a = solve(p, {.robustness = false});
    INFO("speed " << c.speed << ", aim " << aim << ": " << a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(check_shot(p, a.shots.front()).problem == "");
    std::printf("fold at %g m/s, %g degrees: miss %.2g m\n", c.speed, aim, a.shots.front().miss);
  }
  CHECK(folds > 0);
}
