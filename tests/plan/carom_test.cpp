// SPDX-License-Identifier: MIT
//
// Caroms: the cue ball goes off one ball onto another.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/found_again.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

Puzzle carom(const std::string& keys) {
  return read_puzzle(R"({"table": "carom-10ft", "ball": {"at": [0.71, 0.5]}, )" + keys + R"(,
    "others": [{"id": "red", "at": [2.13, 0.71]}, {"id": "yellow", "at": [0.6, 1.15]}]})");
}

}  // namespace

TEST_CASE("caroms that a shot made are found, nearly always, and no shot is wrong", "[heavy]") {
  const auto [model, count] = GENERATE(table<test::Model, int>(
      {{test::Model::ideal, 40}, {test::Model::rolling, 40}, {test::Model::spin, 40}, {test::Model::mathavan, 2}}));
  const test::FoundAgain found = test::find_again("caroms", model, count, 47, 10);
  CAPTURE(found.unsolved);
  CHECK(std::ssize(found.unsolved) <= 1 + count / 20);
}

TEST_CASE("a direct carom touches the first ball and then the second, as it is cut") {
  const Puzzle p = carom(R"("target": {"carom": ["red", "yellow"], "cut": 20, "within": 3}, "cushions": {"max": 2})");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const Shot& s = a.shots.front();
  CHECK(s.path.then.empty());
  REQUIRE(s.path.hits.size() == 2);
  CHECK(s.path.hits[0].ball == 1);
  CHECK(s.path.hits[1].ball == 2);
  CHECK(degrees(s.path.hits[1].cut) == Approx(20).margin(3));
  CHECK(s.path.cushions.size() <= 2);
}

TEST_CASE("three cushions before the second ball, wherever the first is touched between them") {
  const Puzzle p =
      carom(R"("target": {"carom": ["red", "yellow"]}, "cushions": {"min": 3, "max": 4}, "speed": [1, 6])");
  const Answer best = solve(p), all = solve(p, {.all = true});
  REQUIRE(best.status == Status::solved);
  CHECK(all.shots.size() > 5);
  bool before = false, between = false;
  for (const Shot& s : all.shots) {
    CHECK(s.path.cushions.size() >= 3);
    CHECK(s.path.cushions.size() <= 4);
    if (!s.provenance.moved)
      CHECK(s.path.arrival.speed >= 0.2 - 1e-9);  // a default binds shots at their exact launch alone
    CHECK(test::check_shot(p, s).problem.empty());
    before = before || s.path.hits[0].after > 0;
    between = between || s.path.hits[0].after == 0;
  }
  CHECK(before);
  CHECK(between);
  CHECK(*best.shots.front().robustness.success >= *all.shots.front().robustness.success - 0.005);
}

TEST_CASE("a carom that no bound allows says how it was searched") {
  Puzzle p = carom(R"("target": {"carom": ["red", "yellow"]}, "cushions": 0, "speed": [0.1, 0.2])");
  const Answer a = solve(p, {.suggest = false});
  CHECK(a.status == Status::no_shot);
  CHECK_THAT(a.message, Catch::Contains("aims across the first ball"));
}

TEST_CASE("the carom that is answered is the best of all, where the path is straight as well") {
  const Puzzle p = read_puzzle(R"({"physics": "ideal", "speed": 1, "ball": {"at": [0.063, 0.127]},
    "table": {"vertices": [[0.518, 0.066], [-0.166, 0.34], [-0.166, -0.34]]},
    "others": [{"id": "1", "at": [-0.074, 0.102]}, {"id": "2", "at": [0.164, -0.095]}],
    "target": {"carom": ["2", "1"]}})");
  const Answer best = solve(p), all = solve(p, {.all = true});
  REQUIRE(all.shots.size() > 1);
  REQUIRE(best.status == Status::solved);
  CHECK(*best.shots.front().robustness.value >= *all.shots.front().robustness.value - 1e-9);
}
