// SPDX-License-Identifier: MIT
//
// Bounds on aim and speed, and targets whose centre these bounds put out of reach.
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

Puzzle rolling_puzzle(PointTarget target) {
  return {.table = rectangle_table(2.5, 1.25),
          .physics = rolling_physics(),
          .ball = {.at = {1, 0.5}},
          .target = target,
          .cushions = CushionRule::exactly(0)};
}

void check_beside_centre(Puzzle p) {
  p.aim = Aim::centre;
  const Answer a = solve(p);
  INFO(a.message);
  REQUIRE(a.status == Status::solved);
  CHECK(test::check_shot(p, a.shots[0]).problem == "");
  CHECK(a.shots[0].verification.miss > 1e-9 * p.table.diagonal());
  CHECK(a.message.find(is_pocket(p.target) ? "off the exact line" : "off the middle of the target") !=
        std::string::npos);
}

}  // namespace

TEST_CASE("where the slowest launch rolls past the centre, resting within reach of it is made") {
  check_beside_centre(rolling_puzzle({{1.02, 0.5}, 0.1}));
  Puzzle p = rolling_puzzle({{1.08, 0.5}, 0.05});
  p.speed = {0.1, 0.12};
  check_beside_centre(p);
}

TEST_CASE("where the aim's bounds leave out the centre, part of the target still counts") {
  Puzzle p = rolling_puzzle({{2, 0.52}, 0.05});
  p.angle = Range{0, radians(1)};
  check_beside_centre(p);
  const TablePreset& nine = *find_table_preset("pool-9ft");
  Puzzle pocket{.table = make_table(nine),
                .physics = ideal_physics(),
                .ball = {.at = {1, 0.5}},
                .target = PocketTarget{5},
                .cushions = CushionRule::exactly(0)};
  pocket.angle = Range{0, radians(25.9)};
  check_beside_centre(pocket);
}

TEST_CASE("an arrival speed of 0 at a pocket has a miss, and it is a number") {
  Puzzle p{.table = make_table(*find_table_preset("pool-9ft")),
           .physics = rolling_physics(),
           .ball = {.at = {1.9, 0.5}},
           .target = PocketTarget{5},
           .cushions = CushionRule::exactly(0),
           .arrive = Range{0, 0}};
  const Answer a = solve(p);
  CHECK(!a.shots.empty());
  for (const Shot& shot : a.shots) CHECK(shot.verification.miss <= 0.1);
}

TEST_CASE("a beside-the-centre shot keeps the arrival speed that was asked") {
  // The bound excludes the exact line of the corner pocket; at capture the ball must still have 0.8 m/s.
  Puzzle p{.table = make_table(*find_table_preset("pool-9ft")),
           .physics = rolling_physics(),
           .ball = {.at = {1, 0.5}},
           .target = PocketTarget{5},
           .cushions = CushionRule::exactly(0),
           .arrive = Range{0.8, 0.8}};
  p.angle = Range{0, radians(25.9)};
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  CHECK(a.shots[0].path.arrival.speed == Approx(0.8).epsilon(1e-9));
}

TEST_CASE("a ball frozen to a cushion may be aimed into it") {
  Puzzle frozen = rolling_puzzle({{2, 0.5}});
  const double R = frozen.ball.body.radius;
  frozen.ball.at = {1, R};
  frozen.cushions = CushionRule::exactly(1);
  for (const double e : {1.0, 0.8}) {
    frozen.physics = {Rolling{}, Mirror{e}};
    frozen.angle = Range{radians(320), radians(345)};
    const Answer a = solve(frozen);
    REQUIRE(a.status == Status::solved);
    CHECK(a.shots[0].path.cushions == std::vector{Contact::rail(0)});
    CHECK(std::tan(a.shots[0].launch.angle) == Approx(-(0.5 - R) / e));
    frozen.angle = Range{radians(350), radians(359)};
    CHECK(solve(frozen).status == Status::no_shot);
  }
}

TEST_CASE("a target on a cushion line is one shot, not one for each way to count the bounce there") {
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = ideal_physics(),
           .ball = {.at = {0.5, 0.3}, .body = {.radius = 0}},
           .target = PointTarget{{2, 0.4}},
           .cushions = {.min = 0, .max = 1}};
  const Answer a = solve(p, {.all = true, .robustness = false});
  CHECK(a.shots.size() > 2);
  for (std::size_t i = 0; i < a.shots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(std::abs(a.shots[i].launch.angle - a.shots[j].launch.angle) > 1e-6);
}

TEST_CASE("a long path counts as several simulations, so that the budget bounds the work") {
  Puzzle p{.table = polygon_table({{0, 0}, {2, 0}, {1, 1.5}}),
           .physics = ideal_physics(),
           .ball = {.at = {1, 0.5}},
           .target = PointTarget{{0.9, 0.6}},
           .cushions = CushionRule::exactly(20000)};
  p.budget = 1000;
  const Answer a = solve(p, {.robustness = false});
  CHECK(a.status != Status::no_shot);
  CHECK(a.simulations < 3 * budget_of(p));
}
