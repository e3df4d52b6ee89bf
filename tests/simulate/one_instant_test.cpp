// SPDX-License-Identifier: MIT
//
// Tests events that coincide, and balls that start in contact with something.
#include <array>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

ShotRequest on(Table table, Vec2d at, double angle, double radius = 0, double speed = 1) {
  return {.table = std::move(table),
          .physics = ideal_physics(),
          .ball = {at, radius, 0.17},
          .launch = {speed, radians(angle)}};
}

std::vector<std::string> names(const ShotRequest& shot, const Trajectory& t) {
  std::vector<std::string> out;
  for (const Contact c : t.sequence()) out.push_back(contact_name(shot.table, c));
  return out;
}

using Names = std::vector<std::string>;

}  // namespace

/// Returns the first two events of a point with an exact velocity, because no angle is exactly 45 degrees.
std::array<Event, 2> first_two(const Table& table, const State<double>& start, State<double>* end = nullptr) {
  const Boundary boundary(table, {0});
  Simulator sim(boundary, Ideal{}, Mirror{1}, start);
  const std::array<Event, 2> events{sim.step(), sim.step()};
  CHECK(sim.travelled() == 0);
  if (end) *end = sim.state();
  return events;
}

TEST_CASE("in a corner both cushions bounce, in the order of edges when equally fast") {
  State<double> end{};
  const auto [first, second] = first_two(rectangle_table(2, 1), {{1.5, 0.5}, {1, 1}}, &end);
  CHECK(first.contact == Contact::rail(1));
  CHECK(second.contact == Contact::rail(2));
  CHECK(second.same_instant);
  CHECK(end.at == Vec2d{2, 1});
  CHECK(end.velocity == Vec2d{-1, -1});
}

TEST_CASE("in a corner the larger approach speed bounces first") {
  const auto wide = first_two(rectangle_table(2, 1), {{0, 0}, {2, 1}});
  CHECK(wide[0].contact == Contact::rail(1));
  CHECK(wide[1].contact == Contact::rail(2));
  const auto tall = first_two(rectangle_table(1, 2), {{0, 0}, {1, 2}});
  CHECK(tall[0].contact == Contact::rail(2));
  CHECK(tall[1].contact == Contact::rail(1));
}

TEST_CASE("a pocket captures before a cushion bounces") {
  // The ball touches the right cushion and meets the capture circle at x = 1.875, at one instant.
  Table table = rectangle_table(2, 1);
  table.pockets = {{"p", {2.25, 0.5}, 0.375}};
  const Boundary boundary(table, {0.125});
  Simulator sim(boundary, Ideal{}, Mirror{1}, State<double>{{1, 0.5}, {1, 0}});
  CHECK(sim.step().kind == EventKind::pocket);
  CHECK(sim.state().at == Vec2d{1.875, 0.5});
}

TEST_CASE("a point that starts in a point pocket drops only after it has left it") {
  Table table = rectangle_table(2, 1);
  table.pockets = {{"p", {0.5, 0.5}, 0}};
  ShotRequest away = on(table, {0.5, 0.5}, 10);
  away.until.cushions = 1;
  CHECK(simulate(away).end == EventKind::horizon);
  const Trajectory back = simulate(on(table, {0.5, 0.5}, 0));
  CHECK(back.end == EventKind::pocket);  // straight out, off the cushion, and back
  CHECK(back.cushions == 1);
}

TEST_CASE("a ball frozen to a cushion and driven into it bounces at once") {
  ShotRequest shot = on(rectangle_table(2, 1), {1, 0.1}, 300, 0.1);
  shot.until.cushions = 1;
  const Trajectory t = simulate(shot);
  CHECK(names(shot, t) == Names{"bottom"});
  CHECK(t.events[1].time == 0);
  CHECK(t.events[1].state.velocity.y > 0);
}

TEST_CASE("a ball frozen to a cushion rolls along it without bouncing") {
  for (const double angle : {0.0, 180.0}) {
    ShotRequest shot = on(rectangle_table(2, 1), {1, 0.1}, angle, 0.1);
    shot.until.cushions = 1;
    const Trajectory t = simulate(shot);
    CHECK(names(shot, t) == Names{angle == 0 ? "right" : "left"});
    CHECK(t.events[1].state.at.y == 0.1);
  }
  ShotRequest down = on(rectangle_table(2, 1), {0.1, 0.5}, 270, 0.1);
  down.until.cushions = 1;
  CHECK(names(down, simulate(down)) == Names{"bottom"});
}

TEST_CASE("a dead cushion leaves the ball rolling along it") {
  ShotRequest shot = on(polygon_table({{0, 0}, {2, 0.3}, {1.8, 1.4}, {-0.2, 1.1}}), {1, 0.7}, 260, 0.05);
  shot.physics = {Rolling{}, Mirror{0}};
  const Trajectory t = simulate(shot);
  CHECK(t.end == EventKind::rest);
  CHECK(t.cushions <= 4);
}

TEST_CASE("a reflex vertex is met as an arc, and named v") {
  const Table table = polygon_table({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
  ShotRequest shot = on(table, {1.6, 0.4}, 135, 0.1);
  shot.until.cushions = 1;
  const Trajectory t = simulate(shot);
  CHECK(names(shot, t) == Names{"v4"});
  CHECK(norm(t.events[1].state.at - Vec2d{1, 1}) == Approx(0.1).epsilon(1e-13));
  CHECK(dot(t.events[1].state.velocity, t.events[0].state.velocity) == Approx(-1).epsilon(1e-9));
}

TEST_CASE("no path of a point slips between two edges at a reflex vertex") {
  const Table table = polygon_table({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
  const Boundary boundary(table, {0});
  for (int i = 0; i <= 200; ++i) {
    const Vec2d at{1.05 + 0.9 * i / 200, 0.1};
    const Vec2d d = Vec2d{1, 1} - at;
    ShotRequest shot = on(table, at, degrees(std::atan2(d.y, d.x)));
    shot.until.cushions = 20;
    const Trajectory t = simulate(shot);
    for (const Record& e : t.events) CHECK(boundary.clearance(e.state.at) > -1e-12);
    CHECK(t.cushions == 20);
  }
}
