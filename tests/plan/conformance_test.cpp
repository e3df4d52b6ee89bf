// SPDX-License-Identifier: MIT
//
// Requirements on every planner, whatever its method.
#include <algorithm>

#include "bankshot/plan/planner.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"

using namespace bankshot;

namespace {

/// Returns puzzles that every planner must solve.
std::vector<Puzzle> easy_set() {
  const Table plain = rectangle_table(2, 1);
  const Ball ball{.at = {0.4, 0.3}};
  std::vector<Puzzle> set;
  set.push_back({.table = plain,
                 .physics = ideal_physics(),
                 .ball = ball,
                 .target = PointTarget{{1.5, 0.7}},
                 .cushions = CushionRule::exactly(1)});
  set.push_back({.table = plain,
                 .physics = rolling_physics(),
                 .ball = ball,
                 .target = PointTarget{{1.5, 0.7}},
                 .cushions = CushionRule::exactly(0)});
  set.push_back({.table = plain,
                 .physics = rolling_physics(),
                 .ball = ball,
                 .target = PointTarget{{1.5, 0.7}},
                 .cushions = CushionRule::exactly(1),
                 .arrive = Range{0.4, 0.4}});
  set.push_back({.table = make_table(*find_table_preset("pool-9ft")),
                 .physics = rolling_physics(),
                 .ball = {.at = {1.9, 0.5}},
                 .target = PocketTarget{5},
                 .cushions = CushionRule::exactly(0)});
  return set;
}

const auto planner_names = [] {
  std::vector<std::string> names;
  for (const PlannerInfo& p : planners()) names.emplace_back(p.name);
  return names;
}();

bool bends(const std::string& planner) {
  return std::ranges::any_of(planners(), [&](const PlannerInfo& p) { return p.name == planner && p.bends; });
}

}  // namespace

TEST_CASE("every planner solves the easy set and what it returns is true") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  for (Puzzle p : easy_set()) {
    p.aim = Aim::centre;
    const Answer a = solve(p, {.planner = planner});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    const test::Checked c = test::check_shot(p, a.shots.at(0));
    CHECK(c.problem == "");
    CHECK(a.shots[0].verification.miss <= 1e-9 * p.table.diagonal());
  }
}

TEST_CASE("a planner that cannot do a physics refuses it") {
  Puzzle p = easy_set()[1];
  p.physics = spin_physics();
  for (const std::string& planner : planner_names) {
    INFO(planner);
    if (bends(planner))
      CHECK(solve(p, {.planner = planner}).status == Status::solved);
    else
      CHECK_THROWS_WITH(solve(p, {.planner = planner}), Catch::Contains("\"" + planner + "\" does not do"));
  }
}

TEST_CASE("the first shot is a shot, and costs no more than the best") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  std::vector<Puzzle> set = easy_set();
  if (bends(planner))
    set.push_back({.table = rectangle_table(2, 1),
                   .physics = spin_physics(),
                   .ball = {.at = {0.4, 0.3}},
                   .target = PointTarget{{1.5, 0.7}},
                   .cushions = CushionRule::exactly(3)});
  for (const Puzzle& p : set) {
    const Answer best = solve(p, {.planner = planner, .robustness = false}),
                 first = solve(p, {.planner = planner, .first = true, .robustness = false});
    REQUIRE(first.status == Status::solved);
    CHECK(first.shots.size() == 1);
    CHECK(test::check_shot(p, first.shots[0]).problem == "");
    CHECK(first.simulations <= best.simulations);
    CHECK(first.message.find("the first shot found") == 0);
    if (planner == "auto" && p.cushions.max == 3) CHECK(first.simulations * 5 < best.simulations);
  }
  CHECK_THROWS_WITH(solve(set[0], {.planner = planner, .all = true, .first = true}),
                    Catch::Contains("either all shots"));
}

TEST_CASE("what a planner returns survives a replay in 50 digits") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  std::vector<Puzzle> set = easy_set();
  const Table plain = rectangle_table(2, 1);
  if (bends(planner)) {
    set.push_back({.table = plain,
                   .physics = spin_physics(),
                   .ball = {.at = {0.4, 0.3}},
                   .spin = {.side = 0.3},
                   .target = PointTarget{{1.5, 0.7}},
                   .cushions = CushionRule::exactly(1)});
    set.push_back({.table = plain,
                   .physics = spin_physics(),
                   .ball = {.at = {0.4, 0.3}},
                   .target = PointTarget{{1.5, 0.7}},
                   .cushions = CushionRule::exactly(2)});
  }
  int replayed = 0;
  for (const Puzzle& p : set) {
    const auto* point = std::get_if<PointTarget>(&p.target);
    if (!point || p.arrive || is_ideal(p.physics)) continue;  // only puzzles with a stop at a point
    const Answer a = solve(p, {.planner = planner, .robustness = false});
    REQUIRE(a.status == Status::solved);
    const Boundary boundary(p.table, p.ball.body);
    const test::Path path = test::run_truth({boundary, p.physics, start_state(as_request(p, a.shots[0]))});
    std::vector<Contact> sequence;
    for (const test::TruthEvent& e : path.events)
      if (e.kind == EventKind::cushion) sequence.push_back(e.contact);
    CHECK(sequence == a.shots[0].path.cushions);
    CHECK(norm(path.events.back().state.at - point->at) <= 1e-9 * p.table.diagonal());
    ++replayed;
  }
  CHECK(replayed >= (bends(planner) ? 3 : 1));
}

TEST_CASE("the same puzzle gives the same bytes twice") {
  const std::string planner = GENERATE(from_range(planner_names));
  for (const Puzzle& p : easy_set()) {
    const auto once = [&] { return to_json(p, solve(p, {.planner = planner, .all = true}), false); };
    CHECK(once() == once());
  }
}

TEST_CASE("a budget of nothing or almost nothing is kept") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  for (Puzzle p : easy_set())
    for (const long budget : {0L, 10L}) {
      p.budget = budget;
      p.angle = Range{radians(1), radians(2)};  // no shot is there, so the planner has to search
      const Answer a = solve(p, {.planner = planner});
      CHECK((a.status == Status::budget || a.status == Status::no_shot));
      if (budget == 0) CHECK(a.status == Status::budget);
      CHECK(a.simulations <= budget + 100);  // a refinement that has begun is finished
    }
}

TEST_CASE("bounds on speed and aim are kept", "[heavy]") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  int kept = 0;
  for (Puzzle p : easy_set()) {
    p.aim = Aim::centre;
    const Answer free = solve(p, {.planner = "auto", .all = true});
    for (const Shot& shot : free.shots) {
      p.angle = Range{shot.launch.angle - 0.01, shot.launch.angle + 0.01};
      const Answer a = solve(p, {.planner = planner});
      if (a.status != Status::solved) continue;
      CHECK(a.shots[0].launch.angle == Approx(shot.launch.angle).margin(0.0101));
      ++kept;
    }
    if (is_ideal(p.physics)) continue;
    p.angle.reset();
    p.speed = {free.shots[0].launch.speed * 20, free.shots[0].launch.speed * 21};
    CHECK(solve(p, {.planner = planner, .robustness = false}).status != Status::solved);
  }
  CHECK(kept >= 3);
}

TEST_CASE("infeasible puzzles are never solved") {
  const std::string planner = GENERATE(from_range(planner_names));
  INFO(planner);
  Puzzle same_twice;
  same_twice.table = rectangle_table(2, 1);
  same_twice.physics = ideal_physics();
  same_twice.ball.at = {0.4, 0.3};
  same_twice.target = PointTarget{{1.5, 0.7}};
  same_twice.cushions = CushionRule::in_order({Contact::rail(0), Contact::rail(0)});
  CHECK(solve(same_twice, {.planner = planner}).status == Status::no_shot);
  Puzzle too_slow = easy_set()[1];
  too_slow.speed = {0.01, 0.02};
  CHECK(solve(too_slow, {.planner = planner}).status == Status::no_shot);
}
