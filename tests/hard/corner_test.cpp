// SPDX-License-Identifier: MIT
//
// Corners.
// Why hard: The ball meets two cushions at one instant, and rounding decides which comes first.
// Conditioning: With mirrors either order gives the same path, so κ stays small. With spin the orders differ and the
// path jumps; a bound exists on either side of the jump but not across it.
// Asserted: No wrong order outside the bound (ties are counted), the bound where the order agrees, and with mirrors the
// same path on both sides to the bound of each.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr double beside[] = {0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-13, -1e-13, 1e-10, -1e-10, 1e-6, -1e-6, 1e-3, -1e-3};

ShotRequest at_corner(const Table& table, double off, Physics physics) {
  ShotRequest shot{.table = table, .physics = std::move(physics), .ball = {{1, 0.5}, 0.028575, 0.17}, .launch = {2, 0}};
  const Boundary b(table, {0.028575});
  const Vec2d d = b.walls[1].to - shot.ball.at;
  shot.launch.angle = wrap_angle(std::atan2(d.y, d.x) + off);
  return shot;
}

}  // namespace

TEST_CASE("a ball aimed at a corner with spin is true on either side") {
  Worst worst("corners", 6);  // a few ties are normal
  for (const HardCase& c : hard_cases("corners")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("mirrors send a ball back from a square corner by the same path in either order") {
  const Physics mirrors{Rolling{}, Mirror{0.8}};
  const Trajectory middle = simulate(at_corner(rectangle_table(2, 1), 0, mirrors));
  for (const double off : beside) {
    if (std::abs(off) > 1e-10) continue;
    const Trajectory t = simulate(at_corner(rectangle_table(2, 1), off, mirrors));
    CHECK(t.cushions == middle.cushions);
    CHECK(norm(t.events.back().state.at - middle.events.back().state.at) <= 1e-14 + 30 * std::abs(off));
  }
}

TEST_CASE("a ball driven into a corner it touches stays there until its spin is gone") {
  for (const double acute : {1.0, 0.5, 0.2}) {
    ShotRequest shot{.table = polygon_table({{0, 0}, {2, 0}, {2, 2 * acute}}),
                     .physics = spin_physics(),
                     .ball = {{1.2, 0.05}, 0.0285, 0.17},
                     .launch = {1, 0}};
    const Boundary b(shot.table, {0.0285});
    // The ball is frozen to two cushions, with topspin into the vertex at the origin.
    const Wall& w = b.walls[0];
    shot.ball.at = w.from;
    shot.launch = {1e-3, wrap_angle(std::atan2(-b.walls[0].from.y, -b.walls[0].from.x))};
    shot.spin = {.top = 1000};
    const Trajectory t = simulate(shot);
    REQUIRE(t.end == EventKind::rest);
    CHECK(t.events.size() < 400);
    for (const Record& e : t.events) CHECK(b.clearance(e.state.at) >= -b.touch);
  }
}
