// SPDX-License-Identifier: MIT
//
// Tiny, huge and shifted tables.
// Why hard: Any absolute length in the code shows.
// Scaling: With lengths times s and speeds times √s the friction is the same and times scale with √s. For s = 4ᵏ every
// number is multiplied by a power of two, so not a bit may differ. A shift by d rounds coordinates to 2⁻⁵³ d, which
// multiplies the error by d/diagonal.
// Asserted: Equal bits for 4⁻⁵ … 4⁵ (1e-3 … 1e3), the bound for other sizes and for shifts up to 1e4 m.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

ShotRequest scaled(double s, Vec2d shift = {0, 0}) {
  constexpr double R = 0.03125;
  Table table = polygon_table(
      {Vec2d{0, 0} * s + shift, Vec2d{2, 0} * s + shift, Vec2d{2.25, 1} * s + shift, Vec2d{0, 1.125} * s + shift});
  Physics physics = spin_physics({R * s});
  std::get<Han2005>(physics.cushion).height = 1.25 * R * s;
  std::get<SlideRoll>(physics.motion).spinning_friction = 0.015;
  return {.table = table,
          .physics = physics,
          .ball = {Vec2d{0.5, 0.375} * s + shift, R * s, 0.17},
          .launch = {3 * std::sqrt(s), radians(33)},
          .spin = {.top = -0.5, .side = 0.75, .masse = 0.25}};
}

}  // namespace

TEST_CASE("a table of another size has the same path, to the bit for powers of four") {
  const Trajectory one = simulate(scaled(1));
  REQUIRE(one.cushions > 3);
  for (int k = -5; k <= 5; ++k) {
    const double s = std::ldexp(1.0, 2 * k);
    const Trajectory t = simulate(scaled(s));
    REQUIRE(t.sequence() == one.sequence());
    for (std::size_t i = 0; i < t.events.size(); ++i) {
      CHECK(t.events[i].state.at == one.events[i].state.at * s);
      CHECK(t.events[i].time == one.events[i].time * std::sqrt(s));
    }
  }
}

TEST_CASE("tables from a millimetre to a kilometre, near and far from the origin, keep the bound") {
  Worst worst("tables");
  for (const HardCase& c : hard_cases("tables")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("a ball frozen to a cushion far from the origin is accepted and stays inside") {
  for (const double far : {0.0, 1.0, 1e2, 1e4, 1e6}) {
    Table table = rectangle_table(2, 1);
    for (Vec2d& v : table.vertices) v += Vec2d{far, far / 3};
    ShotRequest shot = spin_shot({far + 0.7, far / 3 + 0.028575}, 2, 200, {.masse = 1});
    shot.table = table;
    const Boundary b(table, {0.028575});
    const Trajectory t = simulate(shot);
    CHECK(t.end == EventKind::rest);
    for (const Record& e : t.events) CHECK(b.clearance(e.state.at) >= -b.touch);
  }
}
