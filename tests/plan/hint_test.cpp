// SPDX-License-Identifier: MIT
//
// Tests the suggestions for a puzzle without a shot, with a mock search.
#include "planners/what_would_open.hpp"

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

Puzzle puzzle() {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.6, 0.4]}, "cushions": 2, "speed": [1, 2],
    "others": [{"id": "8", "at": [1.2, 0.6]}], "target": {"pocket": "top-right"}})");
}

Answer shot_at(double speed) {
  Answer a{.status = Status::solved};
  a.shots.push_back({.launch = {speed, 0}});
  return a;
}

bool never(const Shot&) { return false; }

}  // namespace

TEST_CASE("a launch that is too fast is named with the bound that it breaks") {
  const auto faster = [](const Puzzle& p) { return p.others.size() == 1 && p.speed.high > 2 ? shot_at(3) : Answer{}; };
  CHECK(planning::what_would_open(puzzle(), faster, never) == "a launch at 3 m/s would do it, and the bound is 2 m/s");
}

TEST_CASE("where a looser search comes upon a shot as asked, nothing is said and nothing more is searched") {
  int searches = 0;
  const auto within = [&](const Puzzle& p) {
    ++searches;
    return p.others.empty() ? Answer{} : shot_at(1.5);
  };
  const auto is_asked = [](const Shot& shot) { return shot.launch.speed == 1.5; };
  CHECK(planning::what_would_open(puzzle(), within, is_asked).empty());
  CHECK(searches == 2);  // without the ball, with more speed
}

TEST_CASE("a launch inside the bounds that is no shot as asked is not said to break one") {
  const auto within = [](const Puzzle& p) { return p.speed.high > 2 || p.speed.low < 1 ? shot_at(1.5) : Answer{}; };
  CHECK(planning::what_would_open(puzzle(), within, never).empty());
}

TEST_CASE("a shot that only a looser search comes upon is the answer, and holds") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "physics": "rolling",
    "ball": {"at": [1.003167343353486, 0.9895855378304752]}, "speed": [6.874106867447101, 7.56900626727689],
    "others": [{"id": "1", "at": [0.8194009083707215, 1.167980858443458]},
               {"id": "2", "at": [0.33104663522504624, 0.18111229505982407]},
               {"id": "3", "at": [0.16633974000787613, 0.7010244790241309]}],
    "target": {"ball": "1", "cut": 0}, "cushions": 3})");
  REQUIRE(solve(p, {.suggest = false}).status == Status::no_shot);
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  CHECK(test::check_shot(p, a.shots[0]).problem.empty());
  CHECK(a.shots[0].provenance.planner == "relaxed");
  CHECK_THAT(a.message, Catch::Contains("a search with looser bounds came upon it"));
}
