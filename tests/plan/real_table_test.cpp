// SPDX-License-Identifier: MIT
//
// Real tables: tilted tables and rails with cushions of their own are planned like any other.
#include <cmath>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "planners/verify/replay.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

Puzzle bank(const Physics& physics) {
  return {.table = rectangle_table(2.54, 1.27),
          .physics = physics,
          .ball = {.at = {0.635, 0.4}},
          .target = PointTarget{{1.9, 0.3}},
          .cushions = CushionRule::in_order({Contact::rail(2)})};
}

Physics leaning(Physics p, Vec2d tilt) {
  p.tilt = tilt;
  return p;
}

}  // namespace

TEST_CASE("on a table that leans the aim changes steadily, and every physics with weight is solved") {
  for (const Physics& level : {rolling_physics(), spin_physics()}) {
    const double flat = solve(bank(level)).shots.at(0).launch.angle;
    double before = flat;
    for (const double rise : {0.001, 0.002, 0.003, 0.004}) {
      const Answer a = solve(bank(leaning(level, {0, rise})));
      REQUIRE(a.status == Status::solved);
      const Shot& shot = a.shots.at(0);
      CHECK(shot.verification.miss < 1e-9 * 2.84);
      CHECK(shot.path.arrival.speed == 0);
      CHECK(std::abs(shot.launch.angle - before) < 0.1);
      CHECK(shot.launch.angle != before);
      CHECK(std::ranges::find(a.modelled, "tilt") != a.modelled.end());
      before = shot.launch.angle;
    }
  }
}

TEST_CASE("a tilt as good as none changes nothing that one could see") {
  for (const Physics& level : {rolling_physics(), spin_physics()}) {
    const Shot flat = solve(bank(level)).shots.at(0), leans = solve(bank(leaning(level, {1e-9, -1e-9}))).shots.at(0);
    CHECK(std::abs(flat.launch.angle - leans.launch.angle) < 1e-6);
    CHECK(flat.launch.speed == Approx(leans.launch.speed).epsilon(1e-6));
    CHECK(*flat.robustness.success == Approx(*leans.robustness.success).margin(0.01));
  }
}

TEST_CASE("nothing comes to rest where the table is steeper than rolling friction holds") {
  const Answer a = solve(bank(leaning(rolling_physics(), {0.03, 0.02})));
  CHECK(a.status == Status::no_shot);
  CHECK_THAT(a.message, Catch::Contains("leans"));
  Physics slick = rolling_physics();
  std::get<Rolling>(slick.motion).friction = 0;
  CHECK_THAT(solve(bank(slick)).message, Catch::Contains("the rolling friction is 0"));
}

TEST_CASE("a rail with a cushion of its own bounces by it, the others by the physics'") {
  for (Physics physics : {rolling_physics(), spin_physics()}) {
    Puzzle p = bank(physics);
    const Shot usual = solve(p).shots.at(0);
    p.table.own.resize(4);
    p.table.own[2].restitution = restitution(physics);
    const Shot same = solve(p).shots.at(0);
    CHECK(same.launch.angle == Approx(usual.launch.angle).epsilon(1e-12));
    p.table.own[2].restitution = Restitution{0.6};
    const Shot dead = solve(p).shots.at(0);
    CHECK(dead.launch.speed > 1.02 * usual.launch.speed);
    // The shot must be the one on a table whose cushions are all like that one.
    std::visit([](auto& c) { c.restitution = Restitution{0.6}; }, physics.cushion);
    const Shot all = solve(bank(physics)).shots.at(0);
    CHECK(dead.launch.angle == Approx(all.launch.angle).epsilon(1e-10));
    CHECK(dead.launch.speed == Approx(all.launch.speed).epsilon(1e-10));
    // A cushion that is not met changes nothing.
    p.table.own[2] = {};
    p.table.own[0].restitution = Restitution{0.3};
    CHECK(solve(p).shots.at(0).launch.angle == Approx(usual.launch.angle).epsilon(1e-12));
  }
}

TEST_CASE("rails of their own are solved by every route they allow, like those of the physics") {
  test::Random r(11);
  int solved = 0, asked = 0;
  for (int i = 0; i < 60; ++i) {
    Puzzle p = bank(i % 2 == 0 ? rolling_physics() : spin_physics());
    p.ball.at = {r.uniform(0.1, 2.4), r.uniform(0.1, 1.1)};
    p.cushions = CushionRule::exactly(1 + i % 3);
    p.table.own.resize(4);
    for (RailCushion& rail : p.table.own) rail.restitution = Restitution{r.uniform(0.6, 0.95)};
    // The target is reachable: a random launch rests there after this number of cushions.
    ShotRequest shot{
        .table = p.table, .physics = p.physics, .ball = p.ball, .launch = {r.uniform(1.5, 3), r.uniform(0, 6.2)}};
    const Trajectory t = simulate(shot);
    if (t.cushions != p.cushions.min) continue;
    p.target = PointTarget{t.events.back().state.at};
    ++asked;
    const Answer a = solve(p, {.robustness = false});
    solved += a.status == Status::solved;
  }
  CHECK(asked > 10);
  CHECK(solved == asked);
}

TEST_CASE("tilt and own cushions are written as they are read") {
  const std::string text = R"({"table": {"preset": "pool-9ft", "tilt": [0.002, -0.001],
    "cushions": {"top": {"restitution": 0.8}, "left": {"friction": 0.25, "restitution": {"at_rest": 0.9, "per_speed": -0.02}}}},
    "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "any"}, "noise": {"side": 0.02, "top": 0.01, "at": 0.001}})";
  const Puzzle p = read_puzzle(text), again = read_puzzle(write_puzzle(p));
  CHECK(p.physics.tilt == Vec2d{0.002, -0.001});
  CHECK(again.physics.tilt == p.physics.tilt);
  REQUIRE(p.table.own.size() == 4);
  CHECK(p.table.own[2].restitution == Restitution{0.8});
  CHECK(p.table.own[3].friction == 0.25);
  CHECK(!p.table.own[0].any());
  CHECK(again.table == p.table);
  CHECK(again.noise.side == 0.02);
  CHECK(again.noise.top == 0.01);
  CHECK(again.noise.at == 0.001);
}
