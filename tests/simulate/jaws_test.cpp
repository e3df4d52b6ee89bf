// SPDX-License-Identifier: MIT
//
// Pockets with jaws: where their pieces lie, and what a ball between them must never do.
#include <algorithm>
#include <cmath>
#include <random>

#include "bankshot/simulate/trajectory.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

const TablePreset& preset(const char* name) { return *find_table_preset(name); }

ShotRequest request(const TablePreset& p, const Vec2d& at, const Launch& launch) {
  ShotRequest r{.table = make_table(p, true), .physics = spin_physics(p.body, p.nose())};
  r.ball = {.at = at, .body = p.body};
  r.launch = launch;
  return r;
}

/// Draws a shot from anywhere on the table into a mouth.
ShotRequest into_a_mouth(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const char* names[] = {"pool-7ft", "pool-8ft", "pool-9ft", "snooker-12ft"};
  const TablePreset& p = preset(names[random() % 4]);
  const double R = p.body.radius;
  const Vec2d at{R + (p.length - 2 * R) * uniform(random), R + (p.width - 2 * R) * uniform(random)};
  const Table plain = make_table(p, false);
  const Vec2d mouth = plain.pockets[random() % 6].at + Vec2d{uniform(random) - 0.5, uniform(random) - 0.5} * 0.2;
  ShotRequest r = request(p, at, {0.2 * std::pow(50, uniform(random)), 0});
  r.launch.angle = wrap_angle(std::atan2(mouth.y - at.y, mouth.x - at.x));
  r.spin = {2 * uniform(random) - 1, 2 * uniform(random) - 1, random() % 4 == 0 ? uniform(random) - 0.5 : 0};
  return r;
}

void check_into_mouths(int count) {
  std::mt19937_64 random(test::seed_or_fresh(7));
  long touched = 0, dropped = 0, out = 0;
  for (int i = 0; i < count; ++i) {
    const ShotRequest r = into_a_mouth(random);
    const Trajectory t = simulate(r);
    const Boundary boundary(r.table, r.ball.body);
    CAPTURE(i, r.ball.at.x, r.ball.at.y, r.launch.speed, r.launch.angle, r.spin.top, r.spin.side, r.spin.masse);
    CHECK(t.end != EventKind::end);
    double before = energy(r.ball.body, t.events.front().state);
    bool jaw = false;
    for (const Record& e : t.events) {
      if (e.kind == EventKind::jaw) {
        jaw = true;
        CHECK(boundary.clearance(e.state.at) <= 1e-12 * boundary.diagonal);
        CHECK(dot(boundary.normal(e.contact, e.state.at), e.state.velocity) >= 0);
      }
      const double now = energy(r.ball.body, e.state);
      CHECK(now <= before * (1 + 1e-12));
      before = now;
      CHECK(boundary.clearance(e.state.at) >= -1e-12 * boundary.diagonal);
    }
    for (const Leg& leg : t.legs)
      for (const double share : {0.25, 0.5, 0.75})
        if (leg.duration < forever)
          CHECK(boundary.clearance(leg.arc.position(leg.duration * share)) >= -1e-12 * boundary.diagonal);
    touched += jaw;
    dropped += jaw && t.end == EventKind::pocket;
    out += jaw && t.end != EventKind::pocket;
  }
  CHECK(touched > count / 6);
  CHECK(dropped > count / 30);
  CHECK(out > count / 30);
}

}  // namespace

TEST_CASE("the pieces of a pool table's pockets are where the published numbers are") {
  const auto jaws = obstacles(make_table(preset("pool-7ft"), true)).jaws;
  REQUIRE(jaws.size() == 6);
  const auto at = [](const Vec2d& p, double x, double y) { return norm(p - Vec2d{x, y}) < 1e-6; };
  CHECK(jaws[0].breaks.back().end == Approx(0.090669).margin(1e-6));
  CHECK(jaws[1].breaks.front().begin == Approx(0.915850).margin(1e-6));
  CHECK(at(jaws[0].facings[1].to, 0.077741, -0.004452));
  CHECK(at(jaws[0].facings[1].from, 0.018418, -0.050800));
  CHECK(at(jaws[0].facings[0].from, -0.004452, 0.077741));
  CHECK_FALSE(obstacles(make_table(preset("snooker-12ft"), true)).jaws[1].faced());
}

TEST_CASE("a ball between jaws stays inside them, gains no energy and comes to an end") { check_into_mouths(3000); }
TEST_CASE("a million balls between jaws", "[.][long]") { check_into_mouths(1'000'000); }

/// Compares shots that touch a jaw with 50 digits, up to the second cushion.
void check_against_truth(int count) {
  std::mt19937_64 random(test::seed_or_fresh(8));
  test::Worst worst("between jaws", 1 + count / 100);
  while (worst.cases < count) {
    const ShotRequest r = into_a_mouth(random);
    ShotRequest short_one = r;
    short_one.until.cushions = 2;
    const auto at_jaw = [](const Record& e) { return e.kind == EventKind::jaw; };
    if (std::ranges::none_of(simulate(short_one).events, at_jaw)) continue;
    CAPTURE(worst.cases, r.ball.at.x, r.ball.at.y, r.launch.speed, r.launch.angle, r.spin.top, r.spin.side,
            r.spin.masse);
    CHECK(worst.within_bound(test::against_truth(r, 2)));
  }
}

TEST_CASE("paths by jaws agree with 50 digits within the error bound") { check_against_truth(150); }
TEST_CASE("a thousand paths by jaws against 50 digits", "[.][long]") { check_against_truth(1000); }

TEST_CASE("a rail that ends at a tip neither loses a ball nor bounces it twice") {
  const TablePreset& p = preset("pool-9ft");
  const auto jaws = obstacles(make_table(p, true)).jaws;
  const double seam = jaws[1].breaks.back().end, R = p.body.radius;
  for (int i = -200; i <= 200; ++i) {
    // Straight down onto the seam, to within rounding.
    const double x = seam + i * 1e-17 * (1 << (std::abs(i) / 10));
    const Trajectory t = simulate(request(p, {x, 0.5}, {1, radians(270)}));
    long hits = 0;
    for (const Record& e : t.events)
      hits += (e.kind == EventKind::jaw || e.kind == EventKind::cushion) && e.state.at.y < 2 * R;
    CAPTURE(i, x);
    CHECK(hits == 1);
  }
}

TEST_CASE("a ball may start between jaws, against a facing, and at rest in both") {
  const TablePreset& p = preset("pool-7ft");
  const Boundary boundary(make_table(p, true), p.body);
  const Wall& facing = boundary.jaws[0].facings[1];
  const Vec2d against = (facing.from + facing.to * 3) / 4;  // before the capture circle
  for (const double angle : {45.0, 100.0, 225.0, 300.0}) {
    ShotRequest r = request(p, against, {1, radians(angle)});
    validate(r);
    const Trajectory t = simulate(r);
    CHECK(t.end != EventKind::end);
    const bool into = dot(facing.normal, direction(radians(angle))) < 0;
    CHECK((t.events[1].kind == EventKind::jaw && t.events[1].time == 0) == into);
  }
}
