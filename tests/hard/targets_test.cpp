// SPDX-License-Identifier: MIT
//
// Targets on a cushion line, in a corner, at the start point.
// Why hard: The target lies on the edge of what a centre can reach. Half of the aims around the root bounce first, and
// rounding may put the root behind the line. At the start point a shot of length 0 must not count.
// Conditioning: Benign, but one-sided.
// Asserted: An answer that passes a replay by a separate check (miss ≤ 1e-9 of the diagonal).
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"
#include "truth/hard_cases.hpp"

using namespace bankshot;

using namespace bankshot::test;

namespace {

void check_solved(std::string_view hard) {
  for (const Puzzle& p : hard_puzzles(hard)) {
    const Answer a = solve(p, {.robustness = false});
    const Vec2d at = std::get<PointTarget>(p.target).at;
    INFO((is_ideal(p.physics)      ? "ideal"
          : is_straight(p.physics) ? "rolling"
                                   : "spin")
         << ", target " << at.x << ' ' << at.y << ", " << p.cushions.min << " cushions: " << a.message);
    CHECK(a.status == Status::solved);
    if (a.shots.empty()) continue;
    CHECK(check_shot(p, a.shots.front()).problem == "");
    CHECK(a.shots.front().verification.miss <= 1e-9 * p.table.diagonal());
  }
}

}  // namespace

TEST_CASE("targets on a cushion line and in a corner are reached, passing and at rest") {
  check_solved("targets on cushions");
}

TEST_CASE("the start point is reached again by way of cushions") { check_solved("target at the start"); }
