// SPDX-License-Identifier: MIT
//
// Folds.
// Why hard: With massé or side the place of rest, as a function of (aim, speed), folds over. At the fold the Jacobian
// is singular and two roots merge; beyond it there is none. Newton's method only halves its error there in each step,
// and an error δ of the place is √δ of the launch, half of the digits.
// Asserted: At the fold and just inside it an answer is found and replays to 1e-9 of the diagonal. The fold is found by
// bisection of the determinant of dual numbers along a line of launches.
#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"
#include "truth/hard_cases.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("a place of rest on a fold of the map is reached") {
  const std::vector<Puzzle> folds = hard_puzzles("folds");
  CHECK(folds.size() == 4);  // four of the seven searched lines of launches have a fold
  for (const Puzzle& p : folds) {
    const Answer a = solve(p, {.robustness = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(check_shot(p, a.shots.front()).problem == "");
    std::printf("fold at %g m/s: miss %.2g m\n", a.shots.front().launch.speed, a.shots.front().verification.miss);
  }
}
