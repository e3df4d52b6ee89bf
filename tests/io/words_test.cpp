// SPDX-License-Identifier: MIT
//
// The words of an answer: the diamond to aim at, names of speeds, distances, the tip, the fullness of a hit, where the
// cue ball stops, warnings, margins, players.
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

ShotRequest shot(double speed, double angle, const LaunchSpin& spin = {}) {
  const Scene scene = preset_scene("pool-9ft");
  return {.table = scene.table,
          .physics = scene.physics,
          .ball = {.at = {0.635, 0.4}, .body = scene.ball.body},
          .launch = {speed, radians(angle)},
          .spin = spin};
}

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

TEST_CASE("who aims over the ball at the diamond that is named aims at the angle") {
  const Table pool = preset_scene("pool-9ft").table, carom = preset_scene("carom-10ft").table;
  constexpr double behind = 0.0936625;  // 3 11/16 inches
  CHECK(sight_distance(pool) == Approx(behind));
  CHECK(sight_distance(rectangle_table(0.02, 0.01)) == Approx(0.001));
  Random r(31);
  int long_rails = 0;
  for (int i = 0; i < 2000; ++i) {
    const Table& t = i % 2 ? pool : carom;
    const Vec2d size = t.highest();
    const Vec2d from{r.uniform(0.03, size.x - 0.03), r.uniform(0.03, size.y - 0.03)};
    const double angle = r.uniform(0, radians(360));
    INFO("draw " << i << " of seed 31");
    const auto s = sight(t, from, direction(angle));
    REQUIRE(s);
    const Vec2d to = s->at - from;
    CHECK(wrap_angle(std::atan2(to.y, to.x)) == Approx(angle).margin(1e-12));
    // Bottom, right, top, left: the diamond's coordinate along the rail, and its distance behind the nose.
    const bool level = s->cushion % 2 == 0;
    long_rails += level;
    const double along = (level ? s->at.x / size.x : s->at.y / size.y) * (level ? 8 : 4);
    CHECK(s->diamonds == Approx(along).margin(1e-12));
    const double across = level ? s->at.y : s->at.x, edge = s->cushion == 0 || s->cushion == 3 ? 0
                                                            : level                            ? size.y
                                                                                               : size.x;
    CHECK(std::abs(across - edge) == Approx(behind));
  }
  CHECK((long_rails > 800 && long_rails < 1800));
}

TEST_CASE("the line of aim is named by rail, diamond and corner, on a polygon by its part") {
  // From (0.635, 0.4) at 45 degrees, the line crosses the diamonds behind the top rail at x = 0.635 + (1.27 + 0.0936625
  // - 0.4).
  CHECK(aim_words(shot(1, 45)) == "diamond 5.04 of 8 on the top rail, counted from the left (45.00 degrees)");
  CHECK_THAT(aim_words(shot(1, 180)), Contains("diamond 1.26 of 4 on the left rail, counted from the bottom"));
  CHECK_THAT(aim_words(shot(1, 215.8)), Contains(" diamonds beyond the left end of the bottom rail"));
  ShotRequest l = shot(1, 0);
  l.table = polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  CHECK(aim_words(l) == "40 % of the way along cushion c1 from vertex v1 (0.00 degrees)");
}

TEST_CASE("a straight shot is aimed at its pocket") {
  const ShotRequest r = shot(1, 24);
  const Pocket &corner = r.table.pockets[5], &other = r.table.pockets[0];
  CHECK(corner.name == "top-right");
  CHECK_THAT(aim_words(r, &corner), Contains("straight at top-right, 20 mm right of its middle"));
  CHECK_THAT(aim_words(r, &other), Contains("diamond"));
}

TEST_CASE("speeds have names, miles an hour, and the lag for a unit") {
  CHECK_THAT(speed_words(shot(0.4, 0)), Catch::StartsWith("soft touch: 0.40 m/s, 0.9 mph, "));
  CHECK_THAT(speed_words(shot(0.8, 0)), Catch::StartsWith("slow: 0.80 m/s, 1.8 mph, "));
  CHECK_THAT(speed_words(shot(1.5, 0)), Catch::StartsWith("medium: 1.50 m/s, 3.4 mph, "));
  CHECK_THAT(speed_words(shot(2, 0)), Catch::StartsWith("fast: 2.00 m/s, 4.5 mph, "));
  CHECK_THAT(speed_words(shot(4, 0)), Catch::StartsWith("power shot: 4.00 m/s, 8.9 mph, "));
  CHECK_THAT(speed_words(shot(9, 0)), Catch::StartsWith("harder than a power shot: 9.00 m/s, 20.1 mph, "));
  CHECK_THAT(speed_words(shot(12, 0)), Catch::StartsWith("powerful break: 12.00 m/s, 26.8 mph, "));
  ShotRequest lag = shot(1, 0);
  lag.physics = rolling_physics();
  // The lag goes up from a quarter of the table and back at 0.85 of the speed, with R to spare at each end.
  const double a = deceleration(lag.physics), R = lag.ball.body.radius, up = 0.75 * 2.54 - R, back = 2.54 - 2 * R;
  lag.launch.speed = 3 * std::sqrt(2 * a * (back / (0.85 * 0.85) + up));
  CHECK_THAT(speed_words(lag), Contains("3.0 times lag speed"));
  lag.physics = ideal_physics();
  CHECK_THAT(speed_words(lag), !Contains("lag"));
}

TEST_CASE("distances are told as people tell them") {
  const Table t = preset_scene("pool-9ft").table;
  CHECK(distance_words(3.7e-16, t) == "exact");
  CHECK(distance_words(4e-4, t) == "0.4 mm");
  CHECK(distance_words(0.0196, t) == "20 mm");
  CHECK(distance_words(1.234, t) == "1.23 m");
}

TEST_CASE("the tip's place has words, and a warning beyond half the radius") {
  CHECK(tip_words(shot(1, 0)) == "in the centre");
  CHECK(tip_words(shot(1, 0, {.top = -0.5, .side = 1})) == "5.7 mm below the centre, 11.4 mm to the right");
  CHECK_THAT(tip_words(shot(1, 0, {.side = -1.3})), Contains("14.9 mm to the left; a miscue is likely: 52 %"));
  CHECK(may_miscue({.top = 1.3}));
  CHECK(!may_miscue({.top = 0.9, .side = 0.8}));
  ShotRequest rolling = shot(1, 0);
  rolling.physics = rolling_physics();
  CHECK(tip_words(rolling) == "11.4 mm above the centre, so that it rolls from the start");
}

TEST_CASE("a raised cue gives the spin that its words tell") {
  const LaunchSpin wanted{.top = 0.6, .side = 0.4, .masse = 0.4};  // 45 degrees
  CHECK(tip_words(shot(1, 0, wanted)) ==
        "4.8 mm above the centre, 4.6 mm to the right, the cue raised by 45 degrees and seen along it");
  // The spin of a blow J along the cue through the point (right, up) off the centre, in units of v / R.
  const double cue = radians(45), right = 0.4 * wanted.side, up = 0.4 * wanted.top * std::cos(cue), v = std::cos(cue);
  CHECK(2.5 * right * std::cos(cue) / v == Approx(wanted.side));
  CHECK(2.5 * up / v == Approx(wanted.top));
  CHECK(2.5 * right * std::sin(cue) / v == Approx(wanted.masse));
  CHECK_THAT(tip_words(shot(1, 0, {.side = 0.4, .masse = -0.4})), Contains("no cue gives this spin"));
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
  p.leave = Vec2d{0.31, 1.0};
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

TEST_CASE("players are told by all their errors") {
  CHECK(noise_words({}) == "0.125 degrees of aim and 0.075 m/s of speed");
  CHECK(noise_words(Puzzle{}.noise) == "0.125 degrees of aim and 0.075 m/s together with 3 % of speed");
  CHECK(noise_words({.angle = radians(0.2), .speed = 0, .speed_share = 0.05, .tip = 0.0015}) ==
        "0.2 degrees of aim, 5 % of speed and 1.5 mm of where the tip meets the ball");
  CHECK_THAT(player_words({}), Catch::StartsWith("a player who errs by"));
  REQUIRE(players().size() == 3);
  for (const Player& player : players())
    CHECK_THAT(player_words(player.noise), Catch::StartsWith(std::string(player.about) + " who errs by"));
  CHECK(player_words({0, 0}) == "a player without errors");
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
