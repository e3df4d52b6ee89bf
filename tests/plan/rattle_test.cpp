// SPDX-License-Identifier: MIT
//
// Shots that drop by the jaws of their pocket, asked for where none enters cleanly.
#include "support/catch.hpp"

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/random_drop.hpp"
#include "truth/claims.hpp"

namespace bankshot {

TEST_CASE("shots that only rattle in are found, at the speed asked", "[heavy]") {
  int rattling = 0, missed = 0, seen = 0;
  for (std::uint64_t i = 0; seen < 150; ++i) {
    test::Random random(15, i);
    const test::Drop drop = test::random_drop(random, true, true, 4);
    if (!drop.rattles() || !drop.only_at_the_end()) continue;
    ++seen;
    const Answer a = solve(drop.puzzle, {.suggest = false});
    INFO(write_puzzle(drop.puzzle) << " seed 15, " << i);
    if (a.shots.empty()) {
      ++missed;
      continue;
    }
    const Shot& shot = a.shots.front();
    rattling += shot.rattles;
    if (shot.rattles) CHECK((shot.off_centre && shot.planner == "rattles"));
    CHECK(std::abs(shot.arrival.speed - drop.puzzle.arrive->low) < 1e-8);
    for (const truth::Check& c : truth::check(&drop.puzzle, a.id, a)) {
      INFO(truth::name(c.claim) << ": " << c.what);
      CHECK(c.holds());
    }
  }
  CHECK(rattling >= 10);
  CHECK(missed <= 2);
}

}  // namespace bankshot
