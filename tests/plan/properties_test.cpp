// SPDX-License-Identifier: MIT
//
// What must hold of any answer, on random layouts of a pool table that nothing is tuned for.
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

/// The cue ball and so many others anywhere, with the target that each of them falls into any pocket.
Puzzle layout(Random& random, int balls, int object_cushions) {
  const Scene scene = preset_scene("pool-9ft");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  const Boundary boundary(p.table, p.ball.body);
  const Vec2d low = p.table.lowest(), high = p.table.highest();
  std::vector<Vec2d> places;
  while (static_cast<int>(places.size()) <= balls) {
    const Vec2d at{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    const auto apart = [&](const Vec2d& other) { return norm(at - other) > 2.2 * p.ball.body.radius; };
    if (boundary.clearance(at) > 0 && std::ranges::all_of(places, apart)) places.push_back(at);
  }
  p.ball.at = places.front();
  BallTarget target;
  for (const Vec2d& at : std::span(places).subspan(1)) {
    p.others.push_back({at, p.ball.body, std::to_string(p.others.size() + 1)});
    target.balls.push_back(static_cast<int>(p.others.size()));
  }
  target.then = Then{PocketTarget{}, CushionRule{0, object_cushions, {}}, {}};
  p.target = target;
  return p;
}

double value_of(const Puzzle& p) {
  const Answer a = solve(p);
  INFO(a.message);
  REQUIRE(a.status == Status::solved);
  return a.shots.front().value.value();
}

}  // namespace

TEST_CASE("what should I play? is answered on every layout", "[heavy]") {
  const auto seed = test::seed_or_fresh(1);
  CAPTURE(seed);
  Random random(seed);
  for (const int balls : {2, 3, 5, 7, 9, 15}) {
    CAPTURE(balls);
    CHECK(value_of(layout(random, balls, 2)) > 0);
  }
}

TEST_CASE("the safest aim has at least the value of the centre") {
  const auto seed = test::seed_or_fresh(2);
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 12; ++i) {
    Puzzle p = layout(random, 1 + i % 3, 1);
    p.cushions = CushionRule::exactly(0);
    p.aim = Aim::centre;
    const Answer centred = solve(p);
    if (centred.shots.empty()) continue;
    CAPTURE(i);
    p.aim = Aim::safest;
    CHECK(value_of(p) >= *centred.shots.front().value - 1e-9);
  }
}

TEST_CASE("the order of balls changes nothing") {
  const auto seed = test::seed_or_fresh(3);
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 6; ++i) {
    Puzzle p = layout(random, 3, 1);
    p.cushions = CushionRule::exactly(0);
    p.spin = {.top = random.uniform(-0.5, 0.5), .side = random.uniform(-0.5, 0.5)};
    CAPTURE(i);
    const double value = value_of(p);
    std::ranges::reverse(p.others);
    CHECK(value_of(p) == Approx(value).margin(1e-6));
  }
}
