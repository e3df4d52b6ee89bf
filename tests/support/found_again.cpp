// SPDX-License-Identifier: MIT
#include "support/found_again.hpp"

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/claims.hpp"
#include "support/families.hpp"
#include "support/replay_check.hpp"

namespace bankshot::test {

FoundAgain find_again(const std::string& family, Model model, int count, std::uint64_t seed, int each_truth) {
  Random random(seed);
  FoundAgain found;
  for (int i = 0; i < count; ++i) {
    const Made made = find_family(family)->make(random, model, -1);
    CAPTURE(family, seed, i, write_puzzle(made.puzzle));
    const Answer a = solve(made.puzzle, {.suggest = false});
    if (a.status != Status::solved) {
      found.unsolved.push_back(write_puzzle(made.puzzle));
      continue;
    }
    found.off_centre += a.shots.front().verification.off_centre;
    CHECK(check_shot(made.puzzle, a.shots.front()).problem.empty());
    if (i % each_truth == 0) check_claims(made.puzzle, a);
  }
  return found;
}

}  // namespace bankshot::test
