// SPDX-License-Identifier: MIT
//
// Pictures made from C++: a question alone, pictures without words, tables that are tiny, huge or crossed often.
#include "bankshot/draw/svg.hpp"

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
  CHECK_THAT(bare, !Contains("<text") && Contains("<circle"));
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
