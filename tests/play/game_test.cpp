// SPDX-License-Identifier: MIT
//
// "What should I play?": games, their orders, and the plan of an answer.
#include "planners/play/game.hpp"

#include <algorithm>

#include "bankshot/scene/game.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/played.hpp"

using namespace bankshot;
using test::played;

namespace {

/// Three balls of a game, whose target the test gives.
std::string layout(const std::string& target, const std::string& more = "") {
  return R"({"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "noise": {"angle": 0.125, "speed": 0.075},
    "others": [{"id": "9", "at": [1.6, 0.9]}, {"id": "2", "at": [2.2, 0.4]}, {"id": "8", "at": [0.5, 1.0]}], "target": )" +
         target + more + "}";
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

TEST_CASE("a game decides which ball may be potted next") {
  const auto order = [](const std::string& target) { return order_of(read_puzzle(layout(target))); };
  CHECK(order(R"({"game": "rotation"})") == PottingOrder{{2}, {3}, {1}});
  CHECK(order(R"({"game": "any"})") == PottingOrder{{1, 2, 3}});
  CHECK(order(R"({"game": "eight", "group": "solids"})") == PottingOrder{{2}, {3}});
  CHECK(order(R"({"game": "eight", "group": "stripes"})") == PottingOrder{{1}, {3}});
  CHECK(order(R"({"game": "list", "order": ["8", ["2", "9"]]})") == PottingOrder{{3}, {2, 1}});
  CHECK(opponents_order(read_puzzle(layout(R"({"game": "eight", "group": "solids"})"))) == PottingOrder{{1}, {3}});
  // On the 8: the solids that are left are the opponent's, and the puzzle is written so.
  const std::string on_the_eight = R"({"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "others": [
    {"id": "2", "at": [2.2, 0.4]}, {"id": "8", "at": [0.5, 1.0]}], "target": {"game": "eight", "group": "stripes"}})";
  const Puzzle eight = read_puzzle(on_the_eight);
  CHECK(order_of(eight) == PottingOrder{{2}});
  CHECK(opponents_order(eight) == PottingOrder{{1}, {2}});
  CHECK(order_of(read_puzzle(write_puzzle(eight))) == PottingOrder{{2}});
  CHECK(opponents_order(read_puzzle(layout(R"({"game": "any"})"))) == PottingOrder{{1, 2, 3}});
}

TEST_CASE("a game that lacks what it needs says so") {
  CHECK_THAT(complaint(layout(R"({"game": "eight"})")),
             Catch::StartsWith("/target/group: this key is required; on an open table"));
  CHECK(complaint(layout(R"({"game": "list"})")) == "/target/order: this key is required");
  CHECK_THAT(complaint(layout(R"({"game": "any", "group": "solids"})")), Catch::StartsWith("/target/group: "));
  CHECK_THAT(complaint(layout(R"({"game": "any"})", R"(, "leave": {"safe": ["2"]})")), Catch::StartsWith("/leave: "));
  CHECK_THAT(complaint(R"({"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "target": {"game": "any"}})"),
             Catch::StartsWith("/target: "));
  CHECK_THAT(complaint(layout(R"({"game": "any"})", R"(, "physics": "ideal")")), Catch::StartsWith("/target: "));
  CHECK_THAT(complaint(R"({"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "target": {"game": "rotation"},
    "others": [{"id": "red", "at": [1.6, 0.9]}]})"),
             Catch::StartsWith("/others/0/id: "));
}

TEST_CASE("a leave beyond a cushion is refused") {
  CHECK_THAT(complaint(R"({"table": "pool-9ft", "ball": {"at": [1, 0.4]}, "others": [{"id": "8", "at": [2, 0.7]}],
    "target": {"ball": "8", "pocket": "any"}, "leave": {"polygon": [[3, 1], [4, 1], [4, 2]]}})"),
             Catch::StartsWith("/leave/polygon: "));
}

TEST_CASE("a pot by the cushion that is asked for is found in a game, where only side spin leads there") {
  const Answer a = solve(read_puzzle(R"({"table": "pool-8ft", "cushions": ["bottom"],
    "ball": {"at": [0.6, 0.4], "spin": {"top": [-1, 1], "side": [-0.75, 0.75]}},
    "others": [{"id": "8", "at": [2, 0.6]}], "target": {"game": "any"}})"));
  REQUIRE(!a.shots.empty());
  CHECK(!a.shots[0].safety);
  CHECK(a.shots[0].robustness.success.value_or(0) > 0.7);
}

TEST_CASE("a game is written as it is read") {
  const char* const target =
      GENERATE(R"({"game": "rotation"})", R"({"game": "any"})", R"({"game": "eight", "group": "stripes"})",
               R"({"game": "list", "order": ["8", ["2", "9"]]})");
  const Puzzle p = read_puzzle(layout(target)), again = read_puzzle(write_puzzle(p));
  CHECK(again.game == p.game);
  CHECK(order_of(again) == order_of(p));
  CHECK(write_puzzle(again) == write_puzzle(p));
}

TEST_CASE("the question after a shot has the balls that are left") {
  const Puzzle p = read_puzzle(layout(R"({"game": "rotation"})"));
  const std::vector<std::optional<Vec2d>> places{Vec2d{1.0, 0.6}, Vec2d{1.6, 0.9}, std::nullopt, Vec2d{0.6, 1.0}};
  const auto next = next_question(p, places);
  REQUIRE(next);
  CHECK(next->ball.at == *places[0]);
  REQUIRE(next->others.size() == 2);
  CHECK(next->others[1].id == "8");
  CHECK(next->others[1].at == *places[3]);
  CHECK(order_of(*next) == PottingOrder{{2}, {1}});
  CHECK_FALSE(next_question(p, std::vector<std::optional<Vec2d>>{std::nullopt, places[1], std::nullopt, places[3]}));
  CHECK_FALSE(next_question(p, std::vector<std::optional<Vec2d>>{places[0], std::nullopt, std::nullopt, std::nullopt}));
}

TEST_CASE("a plan leads from shot to shot as the simulator plays them", "[heavy]") {
  const Puzzle p = read_puzzle(layout(R"({"game": "rotation"})"));
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  REQUIRE(a.plan);
  REQUIRE(a.plan->next.size() == 2);
  CHECK(a.plan->whole);
  REQUIRE(a.plan->clears.size() == 3);
  CHECK(std::ranges::is_sorted(a.plan->clears, std::greater{}));
  CHECK(a.plan->clears[1] == a.shots.front().leave->success);
  CHECK(a.plan->clears.back() > 0.2);
  const Answer alone = solve(p, {.depth = 0});
  CHECK_FALSE(alone.plan);
  CHECK(alone.shots.front().launch.angle == a.shots.front().launch.angle);
  CHECK(alone.shots.front().launch.speed == a.shots.front().launch.speed);
  const Shot* shot = &a.shots.front();
  Puzzle now = p;
  std::vector<std::string> potted;
  for (std::size_t i = 0;; ++i) {
    potted.push_back(now.others[static_cast<std::size_t>(shot->arriving()) - 1].id);
    const auto next = next_question(now, played(now, shot->launch, shot->spin));
    if (!next || i == a.plan->next.size()) break;
    const Plan::Step& step = a.plan->next[i];
    CHECK(norm(step.puzzle.ball.at - next->ball.at) < 1e-9);
    now = *next;
    shot = &step.shot;
  }
  CHECK(potted == std::vector<std::string>{"2", "8", "9"});
}

TEST_CASE("where a pot leaves the opponent more than it wins, the answer is a safety that touches the right ball",
          "[heavy]") {
  // Ball 1 can be potted only by a hard shot the length of the table.
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "unit": "diamond", "ball": {"at": [5.2, 0.8]}, "cushions": 0,
    "target": {"game": "rotation"}, "others": [{"id": "1", "at": [6, 1]}, {"id": "2", "at": [6, 1.5]},
    {"id": "3", "at": [6, 2]}, {"id": "4", "at": [6.5, 2]}, {"id": "5", "at": [7, 2]}]})");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const Shot& shot = a.shots.front();
  CHECK(shot.safety);
  CHECK_FALSE(a.plan);
  REQUIRE(shot.leave);
  REQUIRE_FALSE(shot.path.hits.empty());
  CHECK(shot.path.hits.front().ball == 1);
  CHECK(played(p, shot.launch, shot.spin)[0]);
}
