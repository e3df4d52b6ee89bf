// SPDX-License-Identifier: MIT
//
// Reflex vertices. Why hard: the ball meets a point, as an arc of radius R around it: roots of a quartic on a curved
// path, edges that end where the arc begins, and dispersion: each such bounce multiplies errors by up to
// 2 · distance/R. Grazing the arc is a double root. Conditioning: κ grows by that factor a bounce. Asserted: the
// bound for aims across a vertex and its neighbourhood, through grazing on both sides; never outside.
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
  ShotRequest shot{.table = ell(), .physics = std::move(physics), .ball = {from, 0.0285, 0.17}, .launch = {3, 0}, .spin = {}};
  const Vec2d d = at - from;
  shot.launch.angle = wrap_angle(std::atan2(d.y, d.x) + off);
  return shot;
}

}  // namespace

TEST_CASE("aims across a reflex vertex keep the bound and the table") {
  Worst worst("reflex vertices");
  const Boundary boundary(ell(), 0.0285);
  for (int i = -40; i <= 40; ++i)
    for (const LaunchSpin& spin : {LaunchSpin{}, LaunchSpin{.top = 1}, LaunchSpin{.top = -1, .side = 0.5, .masse = 0.5}}) {
      ShotRequest shot = towards({1.7, 0.2}, {1, 1}, i * 1e-3, spin_physics(0.0285));
      shot.spin = spin;
      INFO("aim " << i << " mrad beside the vertex");
      CHECK(worst.within_bound(against_truth(shot, 6)));
      for (const Record& e : simulate(shot).events) CHECK(boundary.clearance(e.state.at) >= -boundary.touch);
    }
}

TEST_CASE("grazing the arc of a vertex is a hit or a miss, and true") {
  Worst worst("grazing a reflex vertex");
  // The line of travel passes the vertex at R (1 ± δ).
  for (double delta = 1e-2; delta > 1e-13; delta /= 10)
    for (const double sign : {1.0, -1.0}) {
      const Vec2d from{0.2, 0.2}, d = Vec2d{1, 1} - from;
      const double beside = std::asin(0.0285 * (1 + sign * delta) / norm(d));
      const ShotRequest shot = towards(from, {1, 1}, -beside, {Rolling{}, Mirror{0.9}});
      INFO("passes at R (1 + " << sign * delta << ")");
      const std::vector<int> met = simulate(shot).sequence();
      REQUIRE(!met.empty());
      CHECK((met.front() == 6 + 4) == (sign < 0));
      CHECK(worst.within_bound(against_truth(shot, 2)));
    }
  CHECK(worst.kappa > 1e5);
}

TEST_CASE("a slow ball pressed against a vertex comes to rest") {
  // Topspin drives it at the vertex again and again, e = 0.2.
  ShotRequest shot = towards({1.1, 0.9}, {1, 1}, 0, {SlideRoll{.radius = 0.0285}, Mirror{0.2}});
  shot.launch.speed = 0.5;
  shot.spin = {.top = 1.3};
  const Trajectory t = simulate(shot);
  CHECK(t.end == Trajectory::End::rest);
  CHECK(t.events.size() < 200);
}
