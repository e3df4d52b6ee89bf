// SPDX-License-Identifier: MIT
//
// Targets exactly on a cushion line, and in corners. This is hard because the last bit decides whether the ball bounces
// there. An answer's claims must hold in 50 digits, or the answer must say that it promises nothing.
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/claims.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

Puzzle on_the_edge(test::Random& random) {
  Puzzle p{.table = rectangle_table(random.uniform(1, 3), random.uniform(0.5, 1.5))};
  const int physics = random.integer(0, 2);
  p.physics = physics == 0 ? ideal_physics() : physics == 1 ? rolling_physics() : spin_physics();
  if (physics == 2) p.spin = {random.uniform(-1, 1), random.uniform(-0.5, 0.5), 0};
  const Boundary boundary(p.table, p.ball.body);
  const Vec2d low = boundary.walls[0].from, high = boundary.walls[2].from;
  p.ball.at = {random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
  const Wall& wall = boundary.walls[static_cast<std::size_t>(random.integer(0, 3))];
  p.target = PointTarget{random.chance(0.5) ? wall.from : wall.from + (wall.to - wall.from) * random.uniform(0, 1)};
  const int most = random.integer(0, 2);
  p.cushions = {.min = random.chance(0.5) ? most : 0, .max = most};
  if (physics > 0 && random.chance(0.5)) p.arrive = Range{0.5, 0.5};
  return p;
}

void check_edges(int puzzles, std::uint64_t seed) {
  test::Random random(seed);
  int shots = 0, unpromised = 0;
  for (int i = 0; i < puzzles; ++i) {
    const Puzzle p = on_the_edge(random);
    const Answer a = solve(p, {.robustness = false, .suggest = false});
    INFO("puzzle " << i << " of seed " << seed << ": " << write_puzzle(p));
    for (const Shot& shot : a.shots) ++shots, unpromised += shot.verification.digits == 0;
    test::check_claims(p, a);
  }
  CHECK(shots > puzzles * 9 / 10);
  CHECK(unpromised <= puzzles / 50);
  if (puzzles >= 1000) WARN(unpromised << " of " << shots << " shots promise nothing");
}

}  // namespace

TEST_CASE("what is claimed of targets on cushion lines and in corners holds in 50 digits") { check_edges(60, 47); }

TEST_CASE("a ball comes to rest on a cushion's line, or in a corner, without touching it") {
  const int puzzles = 300;
  test::Random random(48);
  for (int i = 0; i < puzzles; ++i) {
    Puzzle p = on_the_edge(random);
    p.physics = spin_physics();
    p.spin = {random.uniform(-1, 1), 0, 0};
    p.cushions = {.min = 0, .max = 0};
    p.arrive.reset();
    const Answer a = solve(p, {.robustness = false, .suggest = false});
    INFO("puzzle " << i << ": " << write_puzzle(p) << "\n" << a.message);
    REQUIRE(a.status == Status::solved);
    CHECK_FALSE(a.shots.front().verification.off_centre);
    CHECK(a.shots.front().path.cushions.empty());
  }
}

TEST_CASE("what is claimed of targets on cushion lines and in corners holds in 50 digits, at length", "[.][long]") {
  check_edges(1000, test::seed_or_fresh(47));
}
