// SPDX-License-Identifier: MIT
//
// Pots of a ball that touches a rail, or nearly: no exact line leads it into a pocket, since it brushes the rail or a
// jaw. Players pot it all the same.
#include <fmt/format.h>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

/// Returns the value of the best pot of ball 8, which must be true and use no cushion of that ball.
double value_of_pot(const std::string& cue, const std::string& eight, const std::string& more) {
  const Puzzle p = read_puzzle(fmt::format(
      R"({{"table": "pool-9ft", "ball": {{"at": {}}}, "others": [{{"id": "8", "at": {}}}], {}}})", cue, eight, more));
  const Answer a = solve(p);
  INFO(cue << ' ' << eight << ' ' << more << ": " << a.message);
  REQUIRE(a.status == Status::solved);
  CHECK_THAT(test::check_shot(p, a.shots[0]).problem, Catch::Equals(""));
  CHECK(a.shots[0].path.then.back().cushions.empty());
  return *a.shots[0].robustness.value;
}

}  // namespace

TEST_CASE("a ball on a rail is potted, whatever else the question allows") {
  const std::string any = R"("target": {"ball": "8", "pocket": "any"})";
  const std::string one = R"("target": {"ball": "8", "pocket": "top-right"}, "cushions": {"max": 1})";
  for (const char* eight : {"[1.9, 1.241425]", "[1.9, 1.238]", "[2.2, 1.241425]"}) {
    const double narrow = value_of_pot("[0.9, 0.7]", eight, one);
    CHECK(narrow > 0.5);
    CHECK(value_of_pot("[0.9, 0.7]", eight, any) > narrow - 0.01);
    CHECK(value_of_pot("[0.9, 0.7]", eight, any + R"(, "cushions": {"max": 2})") > narrow - 0.01);
  }
}

TEST_CASE("with the tip anywhere a ball on a rail is potted at least as well as with a fixed tip") {
  const std::string tip = R"([0.6, 0.5], "spin": {"top": [-1, 1], "side": [-0.75, 0.75]})", centre = "[0.6, 0.5]";
  const std::string pot = R"("target": {"ball": "8", "pocket": "top-right"})";
  CHECK(value_of_pot(tip, "[1.8, 1.241425]", pot) > value_of_pot(centre, "[1.8, 1.241425]", pot) - 0.01);
}

TEST_CASE("a ball that can only be potted along its rail: the answer says what allows that") {
  const std::string layout =
      R"({"table": "pool-9ft", "ball": {"at": [0.9, 0.7]}, "others": [{"id": "8", "at": [1.9, 1.2412]}], "cushions": {"max": 1})";
  const Puzzle none = read_puzzle(layout + R"(, "target": {"ball": "8", "pocket": "top-right"}})");
  CHECK_THAT(solve(none).message, Catch::Contains(R"("cushions": {"max": 1} in "then")"));
  const Puzzle one =
      read_puzzle(layout + R"(, "target": {"ball": "8", "then": {"pocket": "top-right", "cushions": {"max": 1}}}})");
  const Answer a = solve(one);
  REQUIRE(a.status == Status::solved);
  CHECK_THAT(test::check_shot(one, a.shots[0]).problem, Catch::Equals(""));
  CHECK(*a.shots[0].robustness.value > 0.8);
}
