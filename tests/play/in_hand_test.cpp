// SPDX-License-Identifier: MIT
//
// Ball in hand: where the cue ball may be placed, and where it is.
#include "planners/play/in_hand.hpp"

#include "bankshot/scene/in_hand.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/played.hpp"

using namespace bankshot;
using test::played;

namespace {

std::string puzzle(const std::string& at, const std::string& table = R"("pool-9ft")",
                   const std::string& more = R"("target": {"ball": "1", "pocket": "top-right"})") {
  return R"({"table": )" + table + R"(, "ball": {"at": )" + at +
         R"(}, "others": [{"id": "1", "at": [1.6, 0.9]}, {"id": "2", "at": [0.3, 0.6]}], "cushions": 0, )" + more + "}";
}

std::string complaint(const std::string& text) {
  try {
    read_puzzle(text);
  } catch (const InvalidInput& e) {
    return e.path + ": " + e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the cue ball in hand may be placed in its region, clear of cushions and balls") {
  const Puzzle anywhere = read_puzzle(puzzle(R"("anywhere")")),
               head = read_puzzle(puzzle(R"({"behind": "head-string"})")),
               region = read_puzzle(puzzle("[[1, 0.2], [1.2, 0.2], [1.2, 0.4], [1, 0.4]]")),
               snooker = read_puzzle(puzzle(R"({"behind": "head-string"})", R"("snooker-12ft")"));
  const auto may = [](const Puzzle& p, const Vec2d& at) { return may_place(p, Boundary(p.table, p.ball.body), at); };
  CHECK(may(anywhere, {2.0, 0.3}));
  CHECK_FALSE(may(anywhere, {0.02, 0.3}));   // in the cushion
  CHECK_FALSE(may(anywhere, {1.63, 0.92}));  // in ball 1
  CHECK_FALSE(may(anywhere, {0.0, 0.0}));    // in a pocket
  CHECK(may(head, {0.63, 0.3}));
  CHECK_FALSE(may(head, {0.65, 0.3}));
  CHECK(may(region, {1.1, 0.3}));
  CHECK_FALSE(may(region, {1.3, 0.3}));
  const Vec2d middle = (snooker.table.lowest() + snooker.table.highest()) / 2;
  CHECK(may(snooker, {0.73, middle.y + 0.28}));
  CHECK(may(snooker, {0.46, middle.y}));
  CHECK_FALSE(may(snooker, {0.46, middle.y + 0.28}));  // behind the line, outside the D
  CHECK_FALSE(may(snooker, {0.75, middle.y}));
  for (const Puzzle& p : {anywhere, head, region, snooker}) {
    CHECK(may(p, p.ball.at));
    CHECK(free_places(p, 0.05).size() > 3);
    const Puzzle again = read_puzzle(write_puzzle(p));
    CHECK(again.in_hand->where == p.in_hand->where);
    CHECK(again.in_hand->vertices == p.in_hand->vertices);
  }
}

TEST_CASE("a place in hand that makes no sense is refused with its path") {
  CHECK_THAT(complaint(puzzle(R"("somewhere")")), Catch::StartsWith("/ball/at: "));
  CHECK_THAT(complaint(puzzle("[[1, 0.2], [1.2, 0.2]]")), Catch::StartsWith("/ball/at: "));
  CHECK_THAT(complaint(puzzle(R"({"behind": "head-string"})", R"("carom-10ft")", R"("target": {"ball": "1"})")),
             Catch::StartsWith("/ball/at/behind: "));
  CHECK_THAT(complaint(puzzle("[[1.59, 0.89], [1.61, 0.89], [1.61, 0.91], [1.59, 0.91]]")),
             Catch::EndsWith("has no free place for the cue ball"));
}

TEST_CASE("from the place that is chosen the pot is at least as good as from places all over the region", "[heavy]") {
  const Puzzle p = read_puzzle(puzzle(R"({"behind": "head-string"})"));
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const Shot& shot = a.shots.front();
  REQUIRE(shot.placed);
  CHECK(may_place(p, Boundary(p.table, p.ball.body), *shot.placed));
  const Puzzle there = as_played(p, shot);
  CHECK(there.ball.at == *shot.placed);
  CHECK_FALSE(there.in_hand);
  CHECK_FALSE(played(there, shot.launch, shot.spin)[1]);
  constexpr double step = 0.15, slack = 0.01;
  for (const Vec2d& at : free_places(p, step)) {
    CAPTURE(at.x, at.y);
    const Answer other = solve(placed(p, at), {.suggest = false});
    if (!other.shots.empty()) CHECK(*other.shots.front().robustness.value <= *shot.robustness.value + slack);
  }
  const Answer again = read_answer(to_json(p, a), &p);
  REQUIRE(again.shots.front().placed);
  CHECK(*again.shots.front().placed == *shot.placed);
}

TEST_CASE("the cue ball in hand is not put where a double hit is likely, if another place is as good") {
  const Puzzle asked = read_puzzle(R"({"table": "pool-9ft", "ball": {"at": "anywhere"}, "target": {"game": "rotation"},
    "others": [{"id": "7", "at": [1.651, 0.9843]}, {"id": "8", "at": [2.1907, 0.254]}, {"id": "9", "at": [0.4445, 1.0477]}]})");
  const Answer a = solve(asked, {.depth = 0});
  REQUIRE(!a.shots.empty());
  CHECK(a.shots[0].leave->success > 0.97);
  CHECK_FALSE(may_double_hit(as_played(asked, a.shots[0]), a.shots[0]));
}
