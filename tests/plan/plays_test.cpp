// SPDX-License-Identifier: MIT
#include "planners/evaluate/plays.hpp"

#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

TEST_CASE("plays have the deviations of the player, and parts of the sequence do not overlap") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.8, 0.5]}, "target": {"pocket": "any"},
    "noise": {"angle": 0.2, "speed": 0.1, "tip": 0.001}})");
  const SearchRequest request(p);
  const Launch meant{2, 1};
  constexpr int plays = 4000;
  double angle2 = 0, speed2 = 0, side2 = 0;
  std::vector<double> first, later;
  each_play(request, meant, plays, [&](const SearchRequest& own, const Launch& struck) {
    angle2 += (struck.angle - meant.angle) * (struck.angle - meant.angle) / plays;
    speed2 += (struck.speed - meant.speed) * (struck.speed - meant.speed) / plays;
    side2 += own.spin.side * own.spin.side / plays;
    first.push_back(struck.speed);
    return true;
  });
  CHECK(std::sqrt(angle2) == Approx(p.noise.angle).epsilon(0.02));
  CHECK(std::sqrt(speed2) == Approx(p.noise.speed).epsilon(0.02));
  CHECK(std::sqrt(side2) == Approx(p.noise.side_of(p.ball.body.radius)).epsilon(0.02));
  const auto keep = [&](const SearchRequest&, const Launch& struck) {
    later.push_back(struck.speed);
    return later.size() < 10;
  };
  each_play(request, meant, plays, keep, 100);
  REQUIRE(later.size() == 10);
  CHECK(std::equal(later.begin(), later.end(), first.begin() + 100));
}
