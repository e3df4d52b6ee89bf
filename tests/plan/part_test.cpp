// SPDX-License-Identifier: MIT
//
// Partial targets: the clearance that leads to them, and puzzles in which little more than a sliver is reachable.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "planners/trace/clearance.hpp"
#include "planners/verify/replay.hpp"
#include "support/catch.hpp"
#include "support/lost_puzzles.hpp"
#include "support/random_puzzle.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

TEST_CASE("a launch makes its shot where its clearance is positive, and drops nowhere else") {
  using namespace planning;
  constexpr std::uint64_t seed = 11;
  CAPTURE(seed);
  test::Random random(seed);
  long made = 0, missed = 0, inside = 0, outside = 0;
  for (int i = 0; i < 1500; ++i) {
    const test::Family family = test::families[i % 3];  // no reflex vertices, because they may hide a cushion
    const test::Made m = test::random_puzzle(random, family, test::Model::spin);
    const SearchRequest request(m.puzzle);
    EvaluationBudget budget(budget_of(m.puzzle));
    const Replay exact = replay(request, budget, m.launch, Goal::exactly(request, m.bounces));
    if (!exact.made || !request.problem->touched.empty()) continue;  // a touched cushion may come first
    const std::vector<Contact>& contacts = exact.path.cushions;
    const Route route = route_by(contacts);
    const Branch aim{request, route, request.problem->nearest_aim_point(exact.path.arrival.at)};
    for (int k = 0; k < 20; ++k) {
      const Launch launch{m.launch.speed * random.uniform(0.97, 1.03), m.launch.angle + random.uniform(-0.05, 0.05)};
      const auto room = clearance(aim, budget, launch);
      const bool makes = replay(request, budget, launch, Goal::along(contacts)).made;
      CAPTURE(i, test::name(family), write_puzzle(m.puzzle), launch.speed, launch.angle, room.value_or(-1));
      constexpr double rounding = 1e-9;  // m
      if (room.value_or(-1) > rounding) {
        CHECK(makes);
        ++inside;
      }
      if (aim.aim_point.captures() && room.value_or(-1) < -rounding) {
        CHECK_FALSE(makes);  // a point just before a cushion may still be reached
        ++outside;
      }
      (makes ? made : missed) += 1;
    }
  }
  CHECK(made > 1000);
  CHECK(missed > 1000);
  CHECK(inside > 1000);
  CHECK(outside > 900);
}

TEST_CASE("narrow parts of targets are found") {
  const auto nothing_more = [](const Puzzle&, const Answer&) {};
  CHECK(test::solve_lost_puzzles("tests/plan/narrow_parts.jsonl", nothing_more) == 21);
}
