// SPDX-License-Identifier: MIT
//
// A custom cushion that follows Han's law gives the same plans as Han's cushion, and impossible uses are refused with a
// message.
#include "bankshot/contact/custom.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;

TEST_CASE("a custom cushion with Han's law leads to Han's shots") {
  test::Random random(3);
  test::HanLaw law;
  for (int i = 0; i < 25; ++i) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::spin, i % 4).puzzle;
    law.han = std::get<Han2005>(p.physics.cushion);
    const Answer han = solve(p, {.all = true, .robustness = false});
    p.physics.cushion = CustomCushion{&law, law.han.restitution};
    const Answer own = solve(p, {.all = true, .robustness = false});
    INFO("puzzle " << i << " of seed 3");
    REQUIRE(own.shots.size() == han.shots.size());
    for (std::size_t k = 0; k < own.shots.size(); ++k) {
      const Shot &a = han.shots[k], &b = own.shots[k];
      CHECK(b.path.cushions == a.path.cushions);
      CHECK(std::abs(b.launch.angle - a.launch.angle) * a.verification.condition < 1e-8);
      CHECK(b.launch.speed == Approx(a.launch.speed).epsilon(1e-8));
      CHECK(b.verification.condition == Approx(a.verification.condition).epsilon(1e-5));
    }
    CHECK(own.modelled.at(2) == "custom cushion");
  }
}

TEST_CASE("a custom cushion needs a law and motion with spin, and has no JSON") {
  const test::HanLaw law;
  Puzzle p{.table = rectangle_table(2, 1),
           .physics = spin_physics(),
           .ball = {.at = {0.5, 0.5}},
           .target = PointTarget{{1.5, 0.5}}};
  p.physics.cushion = CustomCushion{&law};
  CHECK_THROWS_WITH(write_puzzle(p), Catch::Contains("a custom cushion is a function"));
  p.physics.cushion = CustomCushion{};
  CHECK_THROWS_WITH(solve(p), Catch::Contains("a custom cushion needs a law"));
  p.physics = {Rolling{}, CustomCushion{&law}};
  CHECK_THROWS_AS(solve(p), InvalidInput);
}
