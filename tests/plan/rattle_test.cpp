// SPDX-License-Identifier: MIT
//
// Jaw shots, for puzzles in which no shot enters the pocket cleanly.
#include <algorithm>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/claims.hpp"
#include "support/random_drop.hpp"

namespace bankshot {
namespace {

struct Counted {
  int rattling = 0;  ///< answers with a shot that touches jaws
  int winding = 0;   ///< of these, shots off other jaws, or back to a cushion
  int missed = 0;
};

bool at_jaw(Contact c) { return c.kind == ContactKind::jaw; }

bool winds(const Shot& shot, const Puzzle& puzzle) {
  const int pocket = *std::get<PocketTarget>(puzzle.target).pocket;
  const auto first = std::ranges::find_if(shot.path.met, at_jaw);
  return std::any_of(first, shot.path.met.end(), [&](Contact c) { return !at_jaw(c) || c.jaw_pocket() != pocket; });
}

/// Solves `count` random drops by jaws. With `at_the_end`, they touch only the jaws of their own pocket, after the last
/// cushion; otherwise they also touch other jaws or a later cushion.
Counted ask(int count, bool spin, bool at_the_end) {
  Counted out;
  for (std::uint64_t i = 0, seen = 0; seen < static_cast<std::uint64_t>(count); ++i) {
    test::Random random(15, i);
    const test::Drop drop = test::random_drop(random, true, spin, 4);
    if (!drop.touches_jaws() || drop.only_at_the_end() != at_the_end) continue;
    ++seen;
    const Answer a = solve(drop.puzzle, {.suggest = false});
    INFO(write_puzzle(drop.puzzle) << " seed 15, " << i);
    if (a.shots.empty()) {
      ++out.missed;
      continue;
    }
    const Shot& shot = a.shots.front();
    out.rattling += shot.path.touches_jaws;
    out.winding += shot.path.touches_jaws && winds(shot, drop.puzzle);
    if (shot.path.touches_jaws) CHECK(shot.verification.off_centre);
    if (shot.path.touches_jaws && spin) CHECK(shot.provenance.planner == "partition");
    CHECK(std::abs(shot.path.arrival.speed - drop.puzzle.arrive->low) < 1e-8);
    test::check_claims(drop.puzzle, a);
  }
  return out;
}

}  // namespace

TEST_CASE("shots that only rattle in are found, at the speed asked", "[heavy]") {
  const Counted c = ask(150, true, true);
  CHECK(c.rattling >= 10);
  CHECK(c.missed == 0);
}

TEST_CASE("shots off the jaws of other pockets, and back to a cushion, are found at the speed asked", "[heavy]") {
  const Counted spin = ask(40, true, false), rolling = ask(100, false, false);
  CHECK(spin.winding >= 5);
  CHECK(spin.missed <= 1);  // about one in a hundred is missed
  CHECK(rolling.winding >= 10);
  CHECK(rolling.missed == 0);
}

}  // namespace bankshot
