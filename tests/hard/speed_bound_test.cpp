// SPDX-License-Identifier: MIT
//
// Targets exactly at the edge of what the speed bound reaches.
// Why hard: The only root lies on a bound, where rounding decides whether it is inside, and a search inside the bounds
// approaches it from one side only.
// Conditioning: d(distance)/d(speed) = 2 distance/speed, benign.
// By hand: A rolling ball goes v²/(2 μr g), a ball struck in the centre 12 v²/(49 μs g) + (5v/7)²/(2 μr g).
// Asserted: The target is reached at the edge, and no shot exists a millionth beyond it.
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"
#include "truth/hard_cases.hpp"

using namespace bankshot;

using namespace bankshot::test;

TEST_CASE("a target exactly as far as the top speed goes is reached, one a millionth further is not") {
  int edges = 0;
  for (Puzzle p : hard_puzzles("edge of the speed bound")) {
    const Answer a = solve(p, {.robustness = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(check_shot(p, a.shots.front()).problem == "");
    CHECK(a.shots.front().launch.speed <= p.speed.high);
    // Only a target at the very edge can be moved out of reach.
    Vec2d& target = std::get<PointTarget>(p.target).at;
    if (a.shots.front().launch.speed < p.speed.high * (1 - 1e-9)) continue;
    ++edges;
    target = p.ball.at + (target - p.ball.at) * (1 + 1e-6);
    CHECK(solve(p, {.robustness = false}).status == Status::no_shot);
  }
  CHECK(edges == 6);
}
