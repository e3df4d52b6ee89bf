// SPDX-License-Identifier: MIT
//
// Tests starts on a cushion or at a vertex: a ball does not bounce off what it does not approach.
#include <algorithm>
#include <cmath>

#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

/// Counts the bounces at the start, before the ball has moved.
long in_place(const Trajectory& t) {
  const Vec2d start = t.events.front().state.at;
  return std::ranges::count_if(
      t.events, [&](const Record& e) { return e.kind == EventKind::cushion && norm(e.state.at - start) < 1e-12; });
}

ShotRequest point_at(Table table, const Vec2d& at, double degrees_of_aim, Physics physics) {
  ShotRequest shot{.table = std::move(table), .physics = std::move(physics), .ball = {at}};
  shot.ball.body.radius = 0;
  shot.launch = {1, wrap_angle(radians(degrees_of_aim))};
  shot.until.time = 0.05;
  return shot;
}

}  // namespace

TEST_CASE("a point at a vertex that points into the table leaves over the table without a bounce") {
  // A square of side 2 without its upper right quarter: vertex 3 at (1, 1) is reflex, and aims from 0 to 90 degrees
  // leave the table.
  const Table table = polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  int over = 0, out = 0;
  for (const Physics& physics : {ideal_physics(), rolling_physics()})
    for (int aim = 0; aim < 360; aim += 3) {
      const Trajectory t = simulate(point_at(table, {1, 1}, aim, physics));
      INFO(aim << " degrees");
      if (aim > 0 && aim < 90) {
        CHECK(in_place(t) == 2);
        ++out;
      } else {
        CHECK(in_place(t) == 0);
        ++over;
      }
    }
  CHECK(over == 2 * 91);
  CHECK(out == 2 * 29);
}

TEST_CASE("a ball at a cushion or in a corner bounces where it is driven in, and nowhere else") {
  int checked = 0;
  for (int aim = 0; aim < 360; aim += 5, ++checked) {
    INFO(aim << " degrees");
    const Table table = rectangle_table(2, 1);
    const auto into = [&](double from, double to) { return aim > from && aim < to ? 1 : 0; };
    CHECK(in_place(simulate(point_at(table, {1, 0}, aim, ideal_physics()))) == into(180, 360));
    CHECK(in_place(simulate(point_at(table, {0, 0}, aim, ideal_physics()))) == into(180, 360) + into(90, 270));
  }
  CHECK(checked == 72);
}
