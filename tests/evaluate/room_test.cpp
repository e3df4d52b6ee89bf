// SPDX-License-Identifier: MIT
//
// The room beside a shot, compared with lines that are moved across it.
#include "planners/evaluate/room.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/proved.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using namespace bankshot::planning;

TEST_CASE("the room beside a pass of a point ends where its disc ends") {
  Puzzle p = test::straight();
  p.target = PointTarget{{1.5, 0.5}, 0.1};
  const SearchRequest request(p);
  for (const double aim : {-0.06, 0.0, 0.03}) {
    const Shot shot = test::shot_of(request, {1, aim});
    const Vec2d left = perpendicular(direction(aim));
    const Gap<double> room = room_beside(request, shot, left), mirrored = room_beside(request, shot, -left);
    CHECK(room.low == Approx(-0.1 - std::sin(aim)));  // the ball passes so far to the left of the point
    CHECK(room.high == Approx(0.1 - std::sin(aim)));
    CHECK((mirrored.low == Approx(-room.high) && mirrored.high == Approx(-room.low)));
  }
}

TEST_CASE("the room beside a fall ends where a line that is moved so far touches a jaw") {
  const Scene scene = preset_scene("pool-9ft", "rolling");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  p.ball.at = {1.7, 0.5};
  p.target = PocketTarget{5};
  p.cushions = CushionRule::exactly(0);
  const SearchRequest request(p);
  const Vec2d way = request.problem->aim_points[0].at - p.ball.at;
  const double turn = GENERATE(-0.005, 0.0, 0.008), side = GENERATE(1.0, -1.0);
  CAPTURE(turn, side);
  const Launch from{2, std::atan2(way.y, way.x) + turn};
  const Vec2d across = perpendicular(direction(from.angle)) * side;
  const Gap<double> room = room_beside(request, test::shot_of(request, from), across);
  const auto falls = [&](double moved) {
    Ball ball = p.ball;
    ball.at += across * moved;
    const Trajectory t = simulate({{}, p.table, p.physics, ball, {}, from, {}, {}});
    const auto bounced = [](const Record& e) { return is_bounce(e.kind); };
    return t.end == EventKind::pocket && std::ranges::none_of(t.events, bounced);
  };
  REQUIRE((room.low < 0 && room.high > 0));
  CHECK(falls(room.low + 1e-6));
  CHECK(!falls(room.low - 1e-6));
  CHECK(falls(room.high - 1e-6));
  CHECK(!falls(room.high + 1e-6));
}
