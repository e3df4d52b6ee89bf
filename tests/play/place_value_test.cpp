// SPDX-License-Identifier: MIT
#include "bankshot/plan/place_value.hpp"

#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

constexpr const char* layout = R"({"table": "pool-9ft", "ball": {"at": [0.6, 0.5]},
  "others": [{"id": "1", "at": [1.9, 0.9]}, {"id": "2", "at": [0.9, 0.4]}, {"id": "3", "at": [2.2, 0.3]}],
  "noise": {"angle": 0.3, "speed": 0.15, "speed_share": 0}, "target": {"game": "rotation"}})";

}  // namespace

TEST_CASE("the estimated value of a place is near the success of the best straight pot from there") {
  const Puzzle puzzle = read_puzzle(layout);
  Puzzle pot = puzzle;
  pot.game.reset();
  pot.leave.reset();
  pot.cushions = CushionRule::exactly(0);
  constexpr std::uint64_t seed = 45;
  INFO("seed " << seed);
  Random random(seed);
  const Boundary boundary(puzzle.table, puzzle.ball.body, puzzle.others);
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  int n = 0;
  while (n < 60) {
    const Vec2d at{random.uniform(0, 2.54), random.uniform(0, 1.27)};
    if (start_at(puzzle, boundary, at) != Start::legal) continue;
    const PlaceValue estimate = estimate_value(puzzle, at);
    REQUIRE(estimate.value >= 0);
    REQUIRE(estimate.value <= 1);
    const Answer exact = solve(placed(pot, at), {.suggest = false});
    const double success = exact.shots.empty() ? 0 : exact.shots.front().robustness.success.value_or(0);
    x += estimate.value, y += success, ++n;
    xx += estimate.value * estimate.value, yy += success * success, xy += estimate.value * success;
  }
  const double correlation = (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
  const double rms = std::sqrt((xx - 2 * xy + yy) / n);
  UNSCOPED_INFO("bias " << (x - y) / n << ", rms " << rms << ", correlation " << correlation);
  CHECK(std::abs(x - y) / n < 0.05);
  CHECK(rms < 0.12);
  CHECK(correlation > 0.9);
}

TEST_CASE("a place's value names the ball and the pocket, and is mirrored with the table") {
  const Puzzle puzzle = read_puzzle(layout);
  Puzzle mirrored = puzzle;
  for (Ball& ball : mirrored.others) ball.at.y = 1.27 - ball.at.y;
  const Vec2d at{0.6, 0.5};
  const PlaceValue value = estimate_value(puzzle, at), other = estimate_value(mirrored, {at.x, 1.27 - at.y});
  CHECK(value.value == Approx(other.value).margin(1e-12));
  CHECK(value.ball == other.ball);
  REQUIRE(value.pocket >= 0);
  REQUIRE(value.ball == 1);
  const Vec2d pocket = puzzle.table.pockets[static_cast<std::size_t>(value.pocket)].at,
              mirror = puzzle.table.pockets[static_cast<std::size_t>(other.pocket)].at;
  CHECK(pocket.x == Approx(mirror.x));
  CHECK(pocket.y == Approx(1.27 - mirror.y));
}

TEST_CASE("only the pockets of the target count, and other questions have no value") {
  Puzzle puzzle = read_puzzle(layout);
  puzzle.game.reset();
  puzzle.leave.reset();
  const auto best_into = [&](std::optional<int> pocket) {
    puzzle.target = ObjectBallTarget{{1, 2, 3}, {.target = PocketTarget{pocket}}};
    return estimate_value(puzzle, {0.6, 0.5});
  };
  const PlaceValue any = best_into({});
  double best = 0;
  for (int pocket = 0; pocket < 6; ++pocket) {
    const PlaceValue value = best_into(pocket);
    CHECK((value.pocket == pocket || value.pocket == -1));
    best = std::max(best, value.value);
  }
  CHECK(best == any.value);
  puzzle.target = PointTarget{{1, 1}};
  CHECK_THROWS_AS(estimate_value(puzzle, {0.6, 0.5}), InvalidInput);
  CHECK_THROWS_AS(value_map(puzzle, 4, 2), InvalidInput);
}

TEST_CASE("a map of values has a row for each cell") {
  const Puzzle puzzle = read_puzzle(layout);
  const ValueMap map = value_map(puzzle, 40, 20);
  REQUIRE(map.values.size() == 800);
  std::size_t legal = 0;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.starts[i] != Start::legal) {
      CHECK(map.values[i].value == 0);
      continue;
    }
    ++legal;
    const PlaceValue alone = estimate_value(puzzle, map.grid.at(i));
    CHECK(map.values[i].value == alone.value);
  }
  CHECK(legal > 700);
  const std::string csv = to_csv(puzzle, map);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 801);
  CHECK(csv.substr(0, csv.find('\n')) == "x_m,y_m,status,value,ball,pocket");
}
