// SPDX-License-Identifier: MIT
//
// The words of a launch: the diamond to aim at, names of speeds, where the tip meets the ball, players.
#include "io/answer/launch_words.hpp"

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
