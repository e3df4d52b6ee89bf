// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "support/family_makers.hpp"
#include "support/nearness.hpp"

namespace bankshot::test::make {
namespace {

/// A ball that the path does not touch: anywhere, or beside a place on the path with as little as a nanometre left.
std::optional<Ball> beside_path(Random& r, const Puzzle& p, const Trajectory& t) {
  Ball ball{{}, p.ball.body, std::to_string(p.others.size() + 1)};
  if (r.chance(0.2)) ball.body.radius *= r.uniform(0.7, 1.25);
  const double apart = p.ball.body.radius + ball.body.radius;
  const Vec2d low = p.table.lowest(), high = p.table.highest();
  ball.at = {r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
  if (r.chance(0.6)) {
    const Leg& leg = t.legs[static_cast<std::size_t>(r.integer(0, static_cast<int>(t.legs.size()) - 1))];
    const double s = leg.duration * r.uniform(0, 1);
    const Vec2d v = leg.arc.tangent(s), left = perpendicular(v) / norm(v);
    ball.at = leg.arc.position(s) + left * ((r.chance(0.5) ? 1 : -1) * (apart + r.log_uniform(1e-9, 0.05)));
  }
  const auto clear = [&](const Ball& other) { return norm(ball.at - other.at) >= other.body.radius + ball.body.radius; };
  if (Boundary(p.table, ball.body).clearance(ball.at) < 0 || !std::ranges::all_of(p.others, clear)) return {};
  if (nearest_on(t, ball.at) < apart + 5e-10) return {};
  return ball;
}

}  // namespace

Made obstacles(Random& r, Model model, int bounces) {
  for (;;) {
    Made made = random_puzzle(r, families[r.integer(0, 2)], model, bounces);
    Puzzle& p = made.puzzle;
    if (!(p.ball.body.radius > 0)) continue;
    ShotRequest shot{{}, p.table, p.physics, p.ball, {}, made.launch, p.spin, {}};
    shot.until.cushions = made.bounces + 1;
    const Trajectory t = simulate(shot);
    const int count = r.integer(1, 8);
    for (int tries = 0; tries < 100 && static_cast<int>(p.others.size()) < count; ++tries)
      if (const auto ball = beside_path(r, p, t)) p.others.push_back(*ball);
    if (!p.others.empty()) return made;
  }
}

}  // namespace bankshot::test::make
