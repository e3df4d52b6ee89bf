// SPDX-License-Identifier: MIT
//
// Reflex vertices.
// Why hard: The ball meets a point, as an arc of radius R around it. On a curved path that is a root of a quartic, and
// edges end where the arc begins. Each such bounce multiplies errors by up to 2 · distance/R. Grazing the arc is a
// double root.
// Conditioning: κ grows by that factor at each bounce.
// Asserted: The bound for aims across a vertex and its neighbourhood, through grazing on both sides; the ball is never
// outside.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

const Table& ell() {
  static const Table made = polygon_table({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
  return made;
}

ShotRequest towards(Vec2d from, Vec2d at, double off, Physics physics) {
  ShotRequest shot{
      .table = ell(), .physics = std::move(physics), .ball = {from, 0.0285, 0.17}, .launch = {3, 0}, .spin = {}};
  const Vec2d d = at - from;
  shot.launch.angle = wrap_angle(std::atan2(d.y, d.x) + off);
  return shot;
}

}  // namespace

TEST_CASE("aims across a reflex vertex keep the bound and the table") {
  Worst worst("reflex vertices");
  for (const HardCase& c : hard_cases("reflex vertices")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
    const Boundary boundary(c.table, {c.radius});
    for (const TruthEvent& e : run_double({boundary, c.physics, c.start}).events)
      CHECK(boundary.clearance(e.state.at) >= -boundary.touch);
  }
}

TEST_CASE("grazing the arc of a vertex is a hit or a miss, and true") {
  Worst worst("grazing a reflex vertex");
  bool hits = false;  // every other case hits
  for (const HardCase& c : hard_cases("grazing a reflex vertex")) {
    INFO(c.what);
    const Boundary boundary(c.table, {c.radius});
    CHECK((run_double({boundary, c.physics, c.start, 1}).events.front().contact == Contact::vertex(4)) ==
          std::exchange(hits, !hits));
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
  CHECK(worst.kappa > 1e5);
}

TEST_CASE("a slow ball pressed against a vertex comes to rest") {
  // Topspin drives the ball at the vertex again and again, e = 0.2.
  ShotRequest shot = towards({1.1, 0.9}, {1, 1}, 0, {SlideRoll{}, Mirror{0.2}});
  shot.launch.speed = 0.5;
  shot.spin = {.top = 1.3};
  const Trajectory t = simulate(shot);
  CHECK(t.end == EventKind::rest);
  CHECK(t.events.size() < 200);
}
