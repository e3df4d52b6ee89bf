// SPDX-License-Identifier: MIT
//
// Tests that all shots are found, by known counts and by two methods that share nothing but the simulator.
#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

TEST_CASE("an ideal rectangle has exactly 4n shots with n cushions") {
  test::Random random(3);
  for (int n = 0; n <= 12; ++n)
    for (int i = 0; i < 20; ++i) {
      Puzzle p{.table = rectangle_table(2.54, 1.27), .physics = ideal_physics()};
      const auto place = [&] { return Vec2d{random.uniform(0.1, 2.44), random.uniform(0.1, 1.17)}; };
      p.ball.at = place();
      p.target = PointTarget{place()};
      p.cushions = CushionRule::exactly(n);
      const Answer a = solve(p, {.all = true, .robustness = false});
      CHECK(a.shots.size() == (n == 0 ? 1u : 4u * static_cast<unsigned>(n)));
    }
}

TEST_CASE("images find every shot that a sweep of the aim finds, and the sweep almost every image") {
  std::size_t images = 0, missed = 0;  // a sweep may miss a route that is narrower than its fan
  for (const test::Family family : {test::Family::uniform, test::Family::convex})
    for (const bool ideal : {true, false}) {
      test::Random random(4);
      for (int i = 0; i < 60; ++i) {
        Puzzle p = test::random_puzzle(random, family, ideal ? test::Model::ideal : test::Model::rolling).puzzle;
        // A target on a cushion is passed at the end of one leg and at the start of the next, so it is left out.
        if (!std::holds_alternative<PointTarget>(p.target)) continue;
        if (Boundary(p.table, p.ball.body).clearance(std::get<PointTarget>(p.target).at) < 1e-3) continue;
        p.cushions = {.min = 0, .max = 3};
        const Answer a = solve(p, {.planner = "image", .all = true, .robustness = false});
        const Answer b = solve(p, {.planner = "sweep", .all = true, .robustness = false});
        INFO(test::name(family) << " number " << i << " of seed 4, ideal " << ideal);
        const auto same = [](const Shot& x) {
          return [&x](const Shot& y) {
            return x.path.cushions == y.path.cushions && std::abs(x.launch.angle - y.launch.angle) < 1e-7;
          };
        };
        for (const Shot& shot : b.shots) CHECK(std::any_of(a.shots.begin(), a.shots.end(), same(shot)));
        images += a.shots.size();
        for (const Shot& shot : a.shots) missed += std::none_of(b.shots.begin(), b.shots.end(), same(shot));
      }
    }
  INFO(missed << " of " << images << " missed by the sweep");
  CHECK(images > 1000);
  CHECK(missed * 500 <= images);
}

TEST_CASE("among reflex vertices a finer sweep finds next to nothing more") {
  std::size_t found = 0, missed = 0;
  test::Random random(9);
  for (int i = 0; i < 12; ++i) {
    Puzzle p = test::random_puzzle(random, test::Family::reflex, test::Model::ideal).puzzle;
    p.cushions = {.min = 0, .max = 2};
    p.budget = 1000000;
    const Answer whole = solve(p, {.all = true, .robustness = false});
    for (int part = 0; part < 12; ++part) {
      p.angle = Range{radians(30 * part), radians(30 * (part + 1))};
      for (const Shot& shot : solve(p, {.all = true, .robustness = false}).shots) {
        if (shot.verification.miss > 1e-9 * p.table.diagonal())
          continue;  // only these bounds keep the shot from the centre
        const auto same = [&](const Shot& x) {
          return x.path.cushions == shot.path.cushions && std::abs(x.launch.angle - shot.launch.angle) < 1e-7;
        };
        ++found;
        missed += std::none_of(whole.shots.begin(), whole.shots.end(), same);
      }
    }
  }
  INFO(missed << " of " << found << " missed");
  CHECK(found > 30);
  CHECK(missed * 100 <= found);
}
