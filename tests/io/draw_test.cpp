// SPDX-License-Identifier: MIT
//
// Pictures made from C++: a puzzle alone, pictures without words, tables that are tiny, huge or crossed often.
#include "bankshot/draw/svg.hpp"

#include <algorithm>

#include "bankshot/scene/json.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using Catch::Contains;

TEST_CASE("the picture of a question shows table, ball and target, and no answer") {
  const Scene scene = preset_scene("pool-9ft");
  const Puzzle p{.table = scene.table,
                 .physics = scene.physics,
                 .ball = {.at = {0.6, 0.4}, .body = scene.ball.body},
                 .target = PocketTarget{5}};
  const std::string question = draw(p, Answer{}), bare = draw(p, Answer{}, {.words = false});
  CHECK_THAT(question, Contains(">top-right<") && !Contains("polyline") && !Contains("No shot"));
  CHECK_THAT(question, Contains("<title>The question: into top-right</title>") && !Contains("no-shot"));
  CHECK_THAT(bare, !Contains("<text") && Contains("<circle"));
}

TEST_CASE("balls move from where they start to where they rest, and those that fall are gone") {
  const ShotRequest shot = read_shot(R"({"table": {"preset": "pool-9ft", "jaws": false}, "ball": {"at": [0.5, 0.5]},
    "others": [{"id": "1", "at": [1, 0.5]}, {"id": "2", "at": [0.4, 1.1]}, {"id": "3", "at": [2.4, 0.13]}],
    "shot": {"speed": 3, "angle": -11}})");
  const Trajectory t = simulate(shot);
  const std::string still = draw(shot, t), moving = draw(shot, t, {.moving = true});
  const auto count = [](const std::string& text, const std::string& part) {
    int n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  int move = 0;
  for (int ball = 0; ball <= 3; ++ball) move += norm(end_of(t, ball).state.at - ball_of(shot, ball).at) > 0;
  REQUIRE(move >= 2);
  CHECK(count(still, "<animate") == 0);
  CHECK(count(moving, "<animateTransform") == move);
  const auto fell = std::ranges::count(t.events, EventKind::pocket, &Record::kind);
  CHECK(count(moving, "<animate ") == fell);
  for (auto at = moving.find("<animateTransform"); at != std::string::npos;
       at = moving.find("<animateTransform", at + 1)) {
    const auto list = [&](const std::string& name) {
      const auto begin = moving.find(name + "=\"", at) + name.size() + 2;
      return moving.substr(begin, moving.find('"', begin) - begin);
    };
    const std::string times = list("keyTimes"), values = list("values");
    CHECK(count(times, ";") == count(values, ";"));
    CHECK(times.starts_with("0;"));
    CHECK(times.ends_with(";1"));
    CHECK(values.starts_with("0.0,0.0;"));
    double before = 0;
    for (std::size_t i = 0; i < times.size();
         i = times.find(';', i) == std::string::npos ? times.size() : times.find(';', i) + 1) {
      const double now = std::stod(times.substr(i));
      CHECK(now >= before);
      before = now;
    }
  }
}

TEST_CASE("a shot of many bounces on any size of table is drawn") {
  const double size = GENERATE(1e-3, 1.0, 1e3);
  const ShotRequest r{.table = rectangle_table(2 * size, size),
                      .physics = ideal_physics(),
                      .ball = {.at = {0.3 * size, 0.4 * size}, .body = {.radius = 0.02 * size}},
                      .launch = {size, 0.7},
                      .until = {.time = {}, .cushions = 500, .length = {}}};
  const Trajectory t = simulate(r);
  REQUIRE(t.cushions == 500);
  const std::string svg = draw(r, t);
  CHECK_THAT(svg, Contains("polyline") && Contains("stopped after") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
}
