// SPDX-License-Identifier: MIT
//
// A phase that ends at the instant of a bounce.
// Why hard: Rounding decides the order of the end of the slide and the bounce, or of rest and bounce.
// Conditioning: Both orders lead to one path (the states agree where the times do), so κ is small. At rest against a
// cushion the speed is 0, and only a bounce of no size can differ.
// Asserted: One path for wall distances within ±20 units in the last place of the coincidence, up to the shift of the
// start. The bound holds where the order agrees with that of 50 digits.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr double R = 0.028575;

}  // namespace

TEST_CASE("a slide that ends at the cushion gives one path in either order") {
  Worst worst("slide ends at a bounce");
  const double v = 2, slide = 12 * v * v / (49 * 0.2 * 9.81);
  Vec2d first{};
  for (int ulps = -20; ulps <= 20; ++ulps) {
    const ShotRequest shot = spin_shot({2 - R - slide + ulps * 0x1p-52, 0.5}, v, 0);
    const Vec2d rest = simulate(shot).events.back().state.at;
    if (ulps == -20) first = rest;
    CHECK(norm(rest - first) <= 10 * (ulps + 20) * 0x1p-52 + 1e-15);  // the start itself moves
  }
  for (const HardCase& c : hard_cases("slide ends at a bounce")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("a ball that comes to rest at a cushion is inside and at rest") {
  const double v = 0.3, roll = v * v / (2 * 0.01 * 9.81);
  for (int ulps = -20; ulps <= 20; ++ulps) {
    const ShotRequest shot = spin_shot({2 - R - roll + ulps * 0x1p-52, 0.5}, v, 0, {.top = 1});
    const Trajectory t = simulate(shot);
    CHECK(t.end == EventKind::rest);
    CHECK(t.events.size() < 60);
    // At a distance δ short of the wall the ball still has the speed √(2 a δ); here δ is at most 20 units and their
    // rounding.
    CHECK(std::abs(t.events.back().state.at.x - (2 - R)) <= 1e-14);
    CHECK(t.events.back().state.at.x <= 2 - R + 1e-15);
  }
}
