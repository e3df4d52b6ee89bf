// SPDX-License-Identifier: MIT
//
// The words of an answer: distances, the fullness of a hit, where the cue ball stops, warnings, margins.
#include "io/answer/words.hpp"

#include <cmath>
#include <string>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/scene/tip.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/answer/sights.hpp"
#include "support/catch.hpp"

namespace {

using namespace bankshot;
using Catch::Contains;
using Catch::Equals;

/// Returns a puzzle with ball 8 as the target, `gap` metres in front of the cue ball.
Puzzle touching(double gap = 0.9) {
  const Scene scene = preset_scene("pool-9ft");
  const double R = scene.ball.body.radius;
  return {.table = scene.table,
          .physics = scene.physics,
          .ball = {.at = {1.6 - gap - 2 * R, 0.4}, .body = scene.ball.body},
          .others = {{.at = {1.6, 0.4}, .body = scene.ball.body, .id = "8"}},
          .target = BallTarget{.balls = {1}}};
}

/// Returns a shot that touches ball 8 at this cut angle [degrees].
Shot touch(const Puzzle& p, double cut) {
  const double a = radians(cut);
  const Vec2d at = p.others[0].at - Vec2d{std::cos(a), std::sin(a)} * (2 * p.ball.body.radius);
  Shot s;
  s.launch = {1.5, 0};
  s.path.hits = {{1, a, 1.2, at}};
  s.path.arrival = {0.7, 1.2, at};
  return s;
}

/// Returns the rows of this name, one per line.
std::string row(const Puzzle& p, const Shot& s, std::string_view name) {
  std::string out;
  for (const Row& r : rows_of(p, s))
    if (r.what == name) out += (out.empty() ? "" : "\n") + r.text;
  return out;
}

}  // namespace

TEST_CASE("distances are told as people tell them") {
  const Table t = preset_scene("pool-9ft").table;
  CHECK(distance_words(3.7e-16, t) == "exact");
  CHECK(distance_words(4e-4, t) == "0.4 mm");
  CHECK(distance_words(0.0196, t) == "20 mm");
  CHECK(distance_words(1.234, t) == "1.23 m");
}

TEST_CASE("what moves or misses nothing is told without a distance") {
  Puzzle p = touching();
  Shot s = touch(p, 20);
  CHECK_THAT(row(p, s, "note"), Equals("a small error of aim does not move the arrival"));
  s.verification.by_angle = {0, 1};
  CHECK_THAT(row(p, s, "note"), Equals("0.1 degrees of aim moves the arrival by 1.7 mm"));
  p.rest_near = s.path.cue_rests = Vec2d{1, 0.5};
  CHECK_THAT(row(p, s, "cue ball"), Contains("exactly where it should be"));
  s.path.cue_rests = Vec2d{1, 0.6};
  CHECK_THAT(row(p, s, "cue ball"), Contains("100 mm from where it should be"));
}

TEST_CASE("how full a hit is has Alciatore's names, its share and its cut") {
  const Puzzle p = touching();
  CHECK(row(p, touch(p, 0), "arrives") == "meets ball \"8\", full hit (100 %), after 0.70 s at 1.20 m/s");
  CHECK_THAT(row(p, touch(p, 6.3), "arrives"), Contains("nearly full hit (89 %), cutting it 6.3 degrees to the left"));
  CHECK_THAT(row(p, touch(p, 14.5), "arrives"), Contains("3/4-ball hit (75 %), cutting it 14.5 degrees to the left"));
  CHECK_THAT(row(p, touch(p, -30), "arrives"), Contains("half-ball hit (50 %), cutting it 30.0 degrees to the right"));
  CHECK_THAT(row(p, touch(p, 48.6), "arrives"), Contains("1/4-ball hit (25 %), cutting it 48.6 degrees to the left"));
  CHECK_THAT(row(p, touch(p, 75), "arrives"), Contains("thin hit (3 %), cutting it 75.0 degrees to the left"));
  CHECK(row(p, touch(p, 0), "ghost") == "ball 1.00 m from the right rail, 0.40 m from the bottom rail");
}

TEST_CASE("where the cue ball stops is told by the rails that are nearer, a scratch on a line of its own") {
  Puzzle p = touching();
  Shot s = touch(p, 30);
  s.path.cue_rests = Vec2d{0.31, 1.05};
  CHECK(row(p, s, "cue ball") == "stops 0.31 m from the left rail, 0.22 m from the top rail");
  p.rest_near = Vec2d{0.31, 1.0};
  CHECK_THAT(row(p, s, "cue ball"), Contains(", 50 mm from where it should be"));
  const Answer stops{.status = Status::solved, .shots = {s}, .message = "one shot found"};
  CHECK_THAT(to_text(p, stops), Contains("\n  cue ball  stops 0.31 m from the left rail") && !Contains("SCRATCH"));
  s.path.cue_rests.reset();
  s.path.scratch = true;
  s.path.scratch_pocket = 3;
  s.robustness.margin = Margin{{0, 0}, {0, 0}};
  const Answer falls{.status = Status::solved, .shots = {s}, .message = "one shot found"};
  CHECK_THAT(to_text(p, falls), Contains("\n  SCRATCH: the cue ball falls into " + p.table.pockets[3].name + "\n"));
  CHECK(row(p, s, "margin") == "none, because the cue ball falls into a pocket");
  Puzzle polygon = p;
  polygon.table = polygon_table({{0, 0}, {2, 0}, {1, 1.5}});
  CHECK(place_words(polygon.table, {1, 0.5}) == "at x = 1.00 m, y = 0.50 m");
}

TEST_CASE("margins are told by their sides") {
  const Puzzle p = touching();
  Shot s = touch(p, 30);
  s.robustness.margin = Margin{{radians(-0.41), radians(0.0568)}, {-0.4, std::nullopt}};
  CHECK(row(p, s, "margin") == "up to 0.41 degrees to the right, up to 0.0568 degrees to the left");
  CHECK_THAT(to_text(p, {.status = Status::solved, .shots = {s}}),
             Contains("\n            up to 0.4 m/s slower, any amount faster\n"));
  s.robustness.margin->speed = {-0.4, 26};
  CHECK_THAT(row(p, s, ""), Contains("any amount faster"));  // no player is as fast
  s.robustness.margin = Margin{{0, radians(1)}, {}};
  CHECK(row(p, s, "margin") == "not to the right, up to 1 degrees to the left");
  CHECK_THAT(row(p, s, ""), Contains("any speed makes it"));
}

TEST_CASE("a likely miscue and a likely double hit are warned of") {
  Puzzle p = touching();
  Shot s = touch(p, 30);
  CHECK(warnings(p, s).empty());
  s.spin = {.side = 2};
  REQUIRE(warnings(p, s).size() == 1);
  CHECK_THAT(row(p, s, "warning"), Contains("likely miscue: the tip may slip off the ball, 0.8 R from its centre"));
  s.spin = {};
  for (const double gap : {0.001, 0.012, 0.02}) {
    const Puzzle near = touching(gap);
    INFO("gap " << gap << " m");
    CHECK_THAT(row(near, touch(near, 0), "warning"), Contains("likely double hit: the cue ball nearly touches ball"));
    CHECK(warnings(near, touch(near, 60)).empty());
    Shot kick = touch(near, 0);
    kick.path.hits[0].after = 1;
    CHECK(!may_double_hit(near, kick));
  }
  const Puzzle frozen = touching(0), far = touching(0.03);
  CHECK(!may_double_hit(frozen, touch(frozen, 0)));
  CHECK(!may_double_hit(far, touch(far, 0)));
}

TEST_CASE("a shot that a player hardly ever makes is hopeless, but not in ideal nor without errors") {
  Puzzle p = touching();
  Shot s = touch(p, 30);
  CHECK(!is_hopeless(p, s));
  s.robustness.success = 0.012;
  CHECK(!is_hopeless(p, s));
  s.robustness.success = 0.009;
  CHECK(is_hopeless(p, s));
  p.noise = {0, 0};
  CHECK(!is_hopeless(p, s));
  p = touching();
  p.physics = ideal_physics();
  CHECK(!is_hopeless(p, s));
}

TEST_CASE("a question about another ball tells its cushions") {
  Puzzle p = touching();
  const auto asks = [&](const Then& then) {
    p.target = ObjectBallTarget{.balls = {1}, .then = then};
    return target_words(p);
  };
  CHECK(asks({.target = PocketTarget{5}}) == "to send ball \"8\" into top-right");
  CHECK(asks({.target = PocketTarget{5}, .cushions = CushionRule::exactly(0)}) == "to send ball \"8\" into top-right");
  CHECK(asks({.target = PocketTarget{5}, .cushions = CushionRule::exactly(1)}) ==
        "to send ball \"8\" off one cushion into top-right");
  CHECK(asks({.target = PocketTarget{}, .cushions = CushionRule{1, 2, {}}}) ==
        "to send ball \"8\" off one to two cushions into any pocket");
  CHECK(asks({.target = PocketTarget{5}, .cushions = CushionRule::in_order({Contact::rail(0)})}) ==
        "to send ball \"8\" by bottom into top-right");
}
