// SPDX-License-Identifier: MIT
//
// The parts of a picture: pixels of places, escaped words, colours that can be told apart, and what is drawn of tables,
// paths, balls and captions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "bankshot/scene/scene.hpp"
#include "io/draw/canvas.hpp"
#include "io/draw/caption.hpp"
#include "io/draw/colours.hpp"
#include "io/draw/escape.hpp"
#include "io/draw/moving.hpp"
#include "io/draw/path.hpp"
#include "io/draw/table.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::drawing;
using Catch::Contains;

namespace {

const Scene pool = preset_scene("pool-9ft", "rolling");

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Returns the relative luminance of a colour such as #12ab9f (WCAG 2).
double luminance(const std::string& colour) {
  double sum = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = static_cast<double>(std::strtol(colour.substr(1 + 2 * k, 2).c_str(), nullptr, 16)) / 255;
    sum += weights[k] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}

ShotRequest rolling_shot() {
  return {.table = pool.table,
          .physics = pool.physics,
          .ball = {.at = {0.6, 0.4}, .body = pool.ball.body},
          .launch = {2, radians(20)}};
}

}  // namespace

TEST_CASE("words are escaped where XML needs it") {
  CHECK(escaped("a < b && b > c") == "a &lt; b &amp;&amp; b &gt; c");
  CHECK(escaped("größer \"x\"") == "größer \"x\"");
  CHECK(escaped("").empty());
}

TEST_CASE("pixels keep the shape of the table, with its y axis downwards") {
  for (const bool words : {true, false}) {
    const Canvas c(pool.table, {.words = words});
    const Vec2d size = pool.table.highest();
    CHECK(c.px(size.x) == Approx(900));  // the longer side
    const Vec2d low = c.at({0, 0}), high = c.at(size);
    CHECK(high.x - low.x == Approx(900));
    CHECK(low.y - high.y == Approx(c.px(size.y)));
    CHECK(c.at(size * 0.5).x == Approx(c.width / 2));
    CHECK(low.x > c.rail);
    CHECK(Canvas::flipped({1, 2}) == Vec2d{1, -2});
  }
}

TEST_CASE("a document holds what was drawn, in order, with its title") {
  Canvas c(pool.table, {});
  c.circle({1, 2}, 3, "fill=\"red\"");
  c.words({4, 5}, "1 < 2", {15, "blue", "middle", true, 90});
  c.line({{0, 0}, {1, 1}}, "polyline", "");
  const std::string svg = c.document("A & B");
  CHECK_THAT(svg,
             Contains("<title>A &amp; B</title>") && Contains(R"(<circle cx="1.0" cy="2.0" r="3.0" fill="red"/>)"));
  CHECK_THAT(svg,
             Contains(R"~(text-anchor="middle" font-weight="bold" transform="rotate(90 4.0 5.0)">1 &lt; 2</text>)~"));
  CHECK(svg.find("<circle") < svg.find("<text"));
  CHECK(svg.find("<text") < svg.find("<polyline"));
}

TEST_CASE("the width of words counts letters, not bytes") {
  CHECK(width_of("", 15) == 0);
  CHECK(width_of("abcd", 30) == Approx(2 * width_of("abcd", 15)));
  CHECK(width_of("größe", 15) == width_of("grose", 15));
}

TEST_CASE("words can be read on what is behind them, and paths seen on the cloth, in both themes") {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Colours& c = colours(theme);
    CHECK(contrast(c.ink, c.page) > 7);
    CHECK(contrast(c.faint, c.page) > 4.5);
    CHECK(contrast(c.cushion_words, c.cushion) > 4.5);
    CHECK(contrast(c.wood_words, c.wood) > 3);
    for (const char* path : c.paths) CHECK(contrast(path, c.cloth) > 3);
    for (std::size_t i = 0; i < c.paths.size(); ++i)
      CHECK(std::count(c.paths.begin(), c.paths.end(), std::string_view(c.paths[i])) == 1);
  }
}

TEST_CASE("a table has six holes, and the diamonds that no pocket covers") {
  Canvas c(pool.table, {});
  draw_table(c, true);
  const std::string svg = c.document("");
  for (const Pocket& p : pool.table.pockets) CHECK_THAT(svg, Contains(fmt::format(">{}<", p.name)));
  for (const std::string& name : pool.table.cushions) CHECK_THAT(svg, Contains(fmt::format(">{}<", name)));
  // Between the corners: seven on each long rail, without the one at the middle pocket, and three on each short one.
  CHECK(count(svg, "l4 5l-4 5l-4-5z") == 2 * 6 + 2 * 3);
  Canvas holes(pool.table, {});
  draw_holes(holes);
  CHECK(count(holes.document(""), "<path") == 6);
}

TEST_CASE("a path is one line with a numbered ball at each bounce") {
  const ShotRequest shot = rolling_shot();
  const Trajectory t = simulate(shot);
  REQUIRE(t.cushions >= 2);
  Canvas c(pool.table, {});
  draw_path(c, shot.ball, t, {.colour = "teal"});
  const std::string svg = c.document("");
  CHECK(count(svg, "<polyline") == 1);
  CHECK(count(svg, "<circle") == t.cushions);
  for (int k = 1; k <= t.cushions; ++k) CHECK_THAT(svg, Contains(fmt::format(">{}</text>", k)));
  Canvas plain(pool.table, {});
  draw_path(plain, shot.ball, t, {.colour = "teal", .dashed = true, .ghosts = false});
  CHECK(count(plain.document(""), "<circle") == 0);
  CHECK_THAT(plain.document(""), Contains("stroke-dasharray"));
}

TEST_CASE("dots stand at equal times, at most forty of them") {
  Trajectory t;
  t.events.resize(2);
  for (const auto& [seconds, step] :
       {std::pair(1.0, 0.5), std::pair(20.0, 0.5), std::pair(20.1, 1.0), std::pair(100.0, 4.0)}) {
    t.events.back().time = seconds;
    CHECK(dot_step(t) == step);
  }
  const ShotRequest shot = rolling_shot();
  const Trajectory rolled = simulate(shot);
  Canvas c(pool.table, {});
  draw_dots(c, shot, rolled, "teal");
  const double last = rolled.events.back().time;
  CHECK(count(c.document(""), "<circle") == static_cast<int>(std::ceil(last / dot_step(rolled))) - 1);
}

TEST_CASE("pool balls have their colours and stripes, carom balls the colour of their name") {
  const Canvas c(pool.table, {});
  const auto colour = [&](const std::string& id) { return colour_of(c, Ball{.id = id}); };
  for (int n = 1; n <= 7; ++n) CHECK(colour(std::to_string(n)) == colour(std::to_string(n + 8)));
  CHECK(colour("1") == colour("yellow"));
  CHECK(colour("3") == colour("red"));
  CHECK(colour("white") == c.c.ball);
  CHECK(colour("16") == colour("anything"));
  const auto drawn = [&](const std::string& id) {
    Canvas one(pool.table, {});
    draw_other(one, Ball{.body = pool.ball.body, .id = id}, {1, 0.5});
    return one.document("");
  };
  CHECK_THAT(drawn("9"), Contains("<path") && Contains(">9</text>"));
  CHECK_THAT(drawn("1"), !Contains("<path") && Contains(">1</text>"));
  CHECK_THAT(drawn("red"), !Contains("<text"));
}

TEST_CASE("a ball that stops has a ring, and one that falls a cross") {
  Canvas stops(pool.table, {}), falls(pool.table, {});
  draw_stop(stops, pool.ball, {1, 0.5}, true);
  draw_stop(falls, pool.ball, {1, 0.5}, false);
  CHECK(count(stops.document(""), "<circle") == 2);
  CHECK(count(falls.document(""), "<circle") == 0);
  CHECK(count(falls.document(""), "<path") == 1);
}

TEST_CASE("a caption grows the page, breaks long rows, and a legend wraps") {
  Canvas c(pool.table, {});
  const double before = c.bottom;
  std::string text;
  for (int i = 0; i < 60; ++i) text += "words ";
  const std::array rows{Row{"what", "short"}, Row{"more", text}};
  draw_caption(c, "A title", rows);
  CHECK(c.bottom > before);
  const std::string svg = c.document("");
  CHECK_THAT(svg, Contains(">A title</text>") && Contains(">short</text>"));
  CHECK(count(svg, ">words words") >= 3);
  const double one_line = [] {
    Canvas legend(pool.table, {});
    const double top = legend.bottom;
    draw_legend(legend, std::array{Swatch{"one", "red"}});
    return legend.bottom - top;
  }();
  const std::array many{Swatch{std::string(60, 'x'), "red"}, Swatch{std::string(60, 'y'), "blue"},
                        Swatch{std::string(60, 'z'), "green"}};
  Canvas legend(pool.table, {});
  const double top = legend.bottom;
  draw_legend(legend, many);
  CHECK(legend.bottom - top > one_line + 20);
  CHECK(count(legend.document(""), "<rect") == 3 + 1);  // and the page
  Canvas list(pool.table, {});
  draw_list(list, "All", std::array{Entry{1, "red", "first"}, Entry{2, "blue", "second"}, Entry{3, "green", "third"}});
  CHECK_THAT(list.document(""), Contains(">third</text>") && Contains(">3</text>"));
}

TEST_CASE("a ball that moves is animated, and one that stands is not") {
  ShotRequest shot = rolling_shot();
  shot.others = {{{2.4, 1.1}, pool.ball.body, "8"}};
  shot.launch = {0.5, radians(180)};
  Canvas c(pool.table, {});
  draw_moving(c, shot);
  const std::string svg = c.document("");
  CHECK(count(svg, "<animateTransform") == 1);
  CHECK_THAT(svg, Contains(">8</text>"));
}
