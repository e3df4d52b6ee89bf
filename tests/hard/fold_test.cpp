// SPDX-License-Identifier: MIT
//
// Folds. Why hard: with massé or side the place of rest as a function of (aim, speed) folds over: at the fold the
// Jacobian is singular, two roots merge, and beyond it there is none. Newton's method halves its error a step there
// instead of squaring it, and an error δ of the place is √δ of the launch: half of the digits. Asserted: at the fold
// and just inside it an answer is found and replays to 1e-9 of the diagonal. The fold is found here by bisection of the
// determinant of dual numbers along a line of launches.
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"
#include "truth/hard_cases.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("a place of rest on a fold of the map is reached") {
  const std::vector<Puzzle> folds = hard_puzzles("folds");
  CHECK(folds.size() == 4);  // of seven lines of launches that are searched
  for (const Puzzle& p : folds) {
    const Answer a = solve(p, {.robustness = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(check_shot(p, a.shots.front()).problem == "");
    std::printf("fold at %g m/s: miss %.2g m\n", a.shots.front().launch.speed, a.shots.front().miss);
  }
}
