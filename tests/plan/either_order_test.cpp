// SPDX-License-Identifier: MIT
//
// Caroms whose balls may be touched in either order.
#include "bankshot/plan/launch_map.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "truth/claims.hpp"

using namespace bankshot;

namespace {

Puzzle carom(const std::string& order, const std::string& balls = R"(["red", "yellow"])") {
  return read_puzzle(R"({"table": "carom-10ft", "ball": {"at": [0.7, 0.4]},
    "others": [{"id": "red", "at": [2.2, 1.1]}, {"id": "yellow", "at": [1.0, 1.2]}],
    "cushions": {"min": 0, "max": 2}, "target": {"carom": )" +
                     balls + R"(, "order": ")" + order + R"("}})");
}

}  // namespace

TEST_CASE("a carom in either order is answered as the better of both orders, and its claims hold", "[heavy]") {
  const Puzzle either = carom("any");
  const Answer a = solve(either), one = solve(carom("given")), other = solve(carom("given", R"(["yellow", "red"])"));
  REQUIRE(a.status == Status::solved);
  const auto value = [](const Answer& x) { return x.shots.empty() ? -1 : *x.shots.front().robustness.value; };
  CHECK(value(a) == std::max(value(one), value(other)));
  for (const truth::Check& check : truth::check(&either, either.id, a)) {
    INFO(truth::name(check.claim) << ": " << check.what);
    CHECK(check.holds());
  }
  CHECK(write_puzzle(read_puzzle(write_puzzle(either))) == write_puzzle(either));
}

TEST_CASE("a list in either order holds the shots of both orders, best first", "[heavy]") {
  const Answer a = solve(carom("any"), {.all = true});
  int red_first = 0, yellow_first = 0;
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    (a.shots[i].path.hits.front().ball == 1 ? red_first : yellow_first) += 1;
    if (i > 0 && a.shots[i].path.scratch == a.shots[i - 1].path.scratch)
      CHECK(*a.shots[i].robustness.value <= *a.shots[i - 1].robustness.value);
  }
  CHECK(red_first > 0);
  CHECK(yellow_first > 0);
}

TEST_CASE("a launch map in either order holds the launches of both orders") {
  const LaunchGrid grid{{0, radians(120.0)}, {1, 4}, 60, 8};
  const auto made = [&](const Puzzle& p) { return launch_map(p, grid).made; };
  const auto both = made(carom("any")), one = made(carom("given")),
             other = made(carom("given", R"(["yellow", "red"])"));
  int count = 0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    CHECK(both[i] == (one[i] || other[i]));
    count += both[i];
  }
  CHECK(count > 0);
}
