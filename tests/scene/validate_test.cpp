// SPDX-License-Identifier: MIT
//
// The rules of scenes and launches, each with the path of the value that breaks it.
#include <cmath>
#include <functional>
#include <limits>

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"
#include "sim/scene/ideal_speeds.hpp"
#include "sim/scene/validate_launch.hpp"
#include "sim/scene/validate_scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::validation;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the path of the rule that is broken; "valid" if none is.
std::string broken(const std::function<void()>& check) {
  try {
    check();
  } catch (const InvalidInput& e) {
    return e.path;
  }
  return "valid";
}

/// Returns the path of what is wrong with a scene after a change; it is valid before.
std::string broken_by(const std::function<void(Scene&)>& change) {
  Scene scene = preset_scene("pool-9ft");
  scene.ball.at = {1, 0.5};
  change(scene);
  return broken([&] { check_scene(scene.table, scene.ball, scene.physics); });
}

}  // namespace

TEST_CASE("a preset is valid, and its boundary is that of its ball") {
  Scene scene = preset_scene("pool-9ft");
  scene.ball.at = {1, 0.5};
  const Boundary boundary = check_scene(scene.table, scene.ball, scene.physics);
  CHECK(boundary.body == scene.ball.body);
  CHECK(boundary.walls.size() == 4);
}

TEST_CASE("each rule of a scene names the value that breaks it") {
  const auto polygon = [](std::vector<Vec2d> vertices) {
    return broken_by([&](Scene& s) { s.table = polygon_table(std::move(vertices)); });
  };
  CHECK(polygon({{0, 0}, {3, 0}}) == "/table/vertices");
  CHECK(polygon({{0, 0}, {3, 0}, {3, not_a_number}, {0, 2}}) == "/table/vertices/2/1");
  CHECK(polygon({{0, 0}, {3, 0}, {3, 0}, {0, 2}}) == "/table/vertices/1");  // no length
  CHECK(polygon({{0, 0}, {0, 2}, {3, 2}, {3, 0}}) == "/table/vertices");    // clockwise
  CHECK(polygon({{0, 0}, {3, 0}, {1, 0}, {0, 2}}) == "/table/vertices/1");  // turns back on itself
  CHECK(polygon({{0, 0}, {3, 2}, {3, 0}, {0, 2}}) == "/table/vertices/2");  // edge 2 crosses edge 0
  CHECK(broken_by([](Scene& s) { s.table.cushions[2] = "bottom"; }) == "/table/names/2");
  CHECK(broken_by([](Scene& s) { s.table.cushions[2] = "v1"; }) == "/table/names");
  CHECK(broken_by([](Scene& s) { s.table.pockets[3].name = "any"; }) == "/table/pockets/3/name");
  CHECK(broken_by([](Scene& s) { s.ball.body.radius = -1; }) == "/ball/radius");
  CHECK(broken_by([](Scene& s) { s.ball.body.mass = 0; }) == "/ball/mass");
  CHECK(broken_by([](Scene& s) { s.ball.at = {0.01, 0.5}; }) == "/ball/at");
  CHECK(broken_by([](Scene& s) { s.ball.at = {not_a_number, 0.5}; }) == "/ball/at/0");
  CHECK(broken_by([](Scene& s) { std::get<SlideRoll>(s.physics.motion).sliding_friction = -0.1; }) ==
        "/physics/sliding_friction");
  CHECK(broken_by([](Scene& s) { std::get<Han2005>(s.physics.cushion).height = 0.01; }) == "/physics/cushion/height");
  CHECK(broken_by([](Scene& s) { std::get<Han2005>(s.physics.cushion).restitution.at_rest = 1.1; }) ==
        "/physics/restitution");
  CHECK(broken_by([](Scene& s) { s.physics.tilt = {0, 1.5}; }) == "/table/tilt");
  CHECK(broken_by([](Scene& s) { s.physics = ideal_physics(), s.physics.tilt = {0, 0.01}; }) == "/table/tilt");
  CHECK(broken_by([](Scene& s) { s.table.own.resize(3); }) == "/table/cushions");
  CHECK(broken_by([](Scene& s) { s.table.own.resize(4), s.table.own[1].friction = -1; }) ==
        "/table/cushions/right/friction");
}

TEST_CASE("other balls stand apart, on the table and under names of their own") {
  Scene scene = preset_scene("pool-9ft");
  scene.ball.at = {1, 0.5};
  const Body body = scene.ball.body;
  const Boundary boundary(scene.table, body);
  const auto wrong = [&](std::vector<Ball> others) {
    return broken([&] { check_others(scene.table, boundary, scene.ball, others, scene.physics); });
  };
  const double touching = 2 * body.radius;
  CHECK(wrong({}) == "valid");
  CHECK(wrong({{{1 + touching, 0.5}, body, "1"}}) == "valid");
  CHECK(wrong({{{1 + touching - 2e-9, 0.5}, body, "1"}}) == "/others/0/at");
  CHECK(wrong({{{2, 0.5}, body, "1"}, {{2, 0.9}, body, "1"}}) == "/others/1/id");
  CHECK(wrong({{{2, 0.5}, body, "cue"}}) == "/others/0/id");
  CHECK(wrong({{{2, 0.001}, body, "1"}}) == "/others/0/at");
  CHECK(wrong({{{2, 0.5}, Body{.radius = 0}, "1"}}) == "/others/0/radius");
  scene.physics.ball_ball.restitution = 1.5;
  CHECK(wrong({{{2, 0.5}, body, "1"}}) == "/physics/ball_ball/restitution");
  scene.physics.ball_ball = {};
  scene.ball.body.radius = 0;
  CHECK(wrong({{{2, 0.5}, body, "1"}}) == "/ball/radius");
}

TEST_CASE("a place is inside up to the rounding of its input") {
  const Boundary boundary(rectangle_table(2, 1), {.radius = 0.1});
  const auto wrong = [&](const Vec2d& at) { return broken([&] { check_inside(boundary, at, "/here", "this"); }); };
  CHECK(wrong({0.1, 0.5}) == "valid");
  CHECK(wrong({0.1 - boundary.touch / 2, 0.5}) == "valid");
  CHECK(wrong({0.1 - 2 * boundary.touch, 0.5}) == "/here");
  CHECK(wrong({1, not_a_number}) == "/here/1");
  CHECK(at("/list", 7) == "/list/7");
  CHECK(broken([] { need_finite(1, "/v"); }) == "valid");
  CHECK(broken([] { need_finite(not_a_number, "/v"); }) == "/v");
}

TEST_CASE("a launch has a speed that can be computed with, and finite numbers") {
  const auto wrong = [](const Launch& launch, const LaunchSpin& spin = {}) {
    return broken([&] { validate(launch, spin); });
  };
  CHECK(wrong({2, 1}) == "valid");
  CHECK(wrong({0, 1}) == "valid");
  CHECK(wrong({-1, 1}) != "valid");
  CHECK(wrong({2e6, 1}) != "valid");
  CHECK(wrong({1e-61, 1}) != "valid");
  CHECK(wrong({2, not_a_number}) != "valid");
  CHECK(wrong({2, 1}, {.side = not_a_number}) != "valid");
}

TEST_CASE("without friction the speeds are those of launch and arrival together") {
  Puzzle p;
  p.speed = {0.5, 4};
  CHECK(ideal_speeds(p).low == 0.5);
  CHECK(ideal_speeds(p).high == 4);
  p.arrive = Range{1, 9};
  CHECK(ideal_speeds(p).low == 1);
  CHECK(ideal_speeds(p).high == 4);
  p.arrive = Range{5, 9};
  const Range none = ideal_speeds(p);
  CHECK(none.low > none.high);
}
