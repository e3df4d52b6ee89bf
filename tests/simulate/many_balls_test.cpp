// SPDX-License-Identifier: MIT
//
// Checks many balls on one table: no ball overlaps another, is lost, gains energy or moves for ever, and the same shot
// gives the same bytes. Collisions of two balls are compared with formulas, and one ball among others with the
// simulator of one ball.
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/with_physics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "support/catch.hpp"
#include "support/random_balls.hpp"
#include "support/random_shot.hpp"
#include "support/seed.hpp"
#include "truth/many_balls.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

/// Statistics of a shot with other balls, updated at each event.
struct Watched {
  double overlap = -1;  ///< the worst [m]
  double gained = 0;    ///< the worst rise between two events, as a fraction of the energy at launch
  double outside = 0;   ///< the farthest that a centre was outside the table [m]
  long events = 0, meetings = 0;
  double time = 0;  ///< s
  bool ended = false;
};

template <class Sim>
void look(const Sim& sim, const ShotRequest& shot, Watched& w, double& energy_before) {
  double sum = 0;
  std::vector<State<double>> now;
  for (int i = 0; i < sim.count(); ++i) {
    now.push_back(sim.state_now(i));
    if (!sim.in_play(i)) continue;
    State<double> s = now.back();
    std::visit([&](const auto& motion) { s.spin = motion.spin(sim.body(i), s); }, shot.physics.motion);
    sum += energy(sim.body(i), s);
    for (int j = 0; j < i; ++j)
      if (sim.in_play(j))
        w.overlap = std::max(w.overlap, touching_distance(sim.body(i), sim.body(j)) -
                                            norm(now.back().at - now[static_cast<std::size_t>(j)].at));
  }
  w.gained = std::max(w.gained, sum - energy_before);
  energy_before = sum;
}

Watched watched(const ShotRequest& shot) {
  const Starts starts(shot);
  const BallBall law = collisions(shot.physics);
  return with_physics(shot.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(starts.balls(), motion, cushion, law);
    Watched w;
    double before = 1e300;
    look(sim, shot, w, before);
    const double launch = before;
    for (; w.events < 20000; ++w.events) {
      const double left = shot.until.time.value_or(forever) - sim.time();
      // A step may end between events.
      const BallEvent e = sim.step(std::min(left, 0.05));
      look(sim, shot, w, before);
      if (e.event.kind == EventKind::ball) ++w.meetings;
      bool moves = false;
      for (int i = 0; i < sim.count(); ++i) moves = moves || sim.moves(i);
      w.ended = !moves || (e.event.kind == EventKind::horizon && left <= 0.05);
      if (w.ended) break;
    }
    w.gained /= launch;
    w.time = sim.time();
    return w;
  });
}

ShotRequest two_balls(double cut_offset, double speed, double top) {
  ShotRequest shot{.table = rectangle_table(40, 20), .physics = spin_physics()};
  const double R = shot.ball.body.radius;
  shot.physics.ball_ball = {1, 0};
  shot.ball.at = {10, 10};
  shot.others = {{{12, 10 + 2 * R * cut_offset}, shot.ball.body, "1"}};
  shot.launch = {speed, 0};
  shot.spin.top = top;
  return shot;
}

/// Returns the direction of the cue ball once it rolls again after the contact [degrees].
double deflection(const Trajectory& t) {
  bool met = false;
  for (const Record& e : t.events) {
    met = met || e.kind == EventKind::ball;
    if (met && e.kind == EventKind::slide_to_roll && e.ball == 0)
      return std::abs(degrees(std::atan2(e.state.velocity.y, e.state.velocity.x)));
  }
  return -1;
}

}  // namespace

TEST_CASE("a rolling ball leaves a quarter, half and three quarter hit at the angles of the theory") {
  CHECK(deflection(simulate(two_balls(0.75, 2, 1))) == Approx(27.266855).margin(5e-7));
  CHECK(deflection(simulate(two_balls(0.5, 2, 1))) == Approx(33.670497).margin(5e-7));
  CHECK(deflection(simulate(two_balls(0.25, 2, 1))) == Approx(27.626486).margin(5e-7));
  CHECK(deflection(simulate(two_balls(std::sin(radians(28.1)), 2, 1))) == Approx(33.749).margin(5e-4));
}

TEST_CASE("a rolling ball meets another as it was measured") {
  // Mathavan, Jackson & Parkin 2014, snooker balls: speeds and directions when both balls roll again.
  struct Measured {
    double speed, cut, cue_speed, cue_turned, speed_sent, sent;
  };
  for (const Measured& m :
       {Measured{1.539, 33.83, 0.914, 31.93, 0.831, 32.20}, {1.364, 40.52, 0.917, 29.91, 0.676, 38.62}}) {
    ShotRequest shot{.table = rectangle_table(40, 20), .physics = spin_physics()};
    shot.ball.body = {0.02625, 0.1406};
    std::get<SlideRoll>(shot.physics.motion).sliding_friction = 0.21;
    shot.physics.ball_ball = {0.89, 0.05};
    shot.ball.at = {10, 10};
    const Vec2d apart = direction(radians(m.cut)) * (2 * shot.ball.body.radius + 1e-9);
    shot.others = {{shot.ball.at + apart, shot.ball.body, "1"}};
    shot.launch = {m.speed, 0};
    shot.spin.top = 1;
    const Trajectory t = simulate(shot);
    const auto rolls = [&](int ball) {
      const auto met = std::ranges::find(t.events, EventKind::ball, &Record::kind);
      const auto found = std::find_if(
          met, t.events.end(), [&](const Record& e) { return e.kind == EventKind::slide_to_roll && e.ball == ball; });
      REQUIRE(found != t.events.end());
      return found->state.velocity;
    };
    const Vec2d cue = rolls(0), sent = rolls(1);
    const auto turned = [](const Vec2d& v) { return std::abs(degrees(std::atan2(v.y, v.x))); };
    CHECK(norm(cue) == Approx(m.cue_speed).margin(0.006));
    CHECK(turned(cue) == Approx(m.cue_turned).margin(0.5));
    CHECK(norm(sent) == Approx(m.speed_sent).margin(0.006));
    CHECK(turned(sent) == Approx(m.sent).margin(0.1));
  }
}

TEST_CASE("after a stun shot without friction two equal balls part at right angles") {
  for (const double offset : {0.1, 0.5, 0.9}) {
    ShotRequest shot = two_balls(offset, 2, 0);
    shot.others[0].at.x = 10 + 0.0572;  // so near that the cue ball has not begun to roll
    shot.physics.motion = SlideRoll{.sliding_friction = 0};
    shot.until.time = 1;
    const Trajectory t = simulate(shot);
    const auto met = std::ranges::find(t.events, EventKind::ball, &Record::kind);
    REQUIRE(met != t.events.end());
    CHECK(std::abs(dot(met->state.velocity, met->other.velocity)) < 1e-14);
  }
}

TEST_CASE("a ball that meets no other moves as if it were alone, to the bit") {
  Random r(43);
  int alone = 0;
  for (int i = 0; i < 300; ++i) {
    ShotRequest shot = random_shot(r, ShotFamily::uniform);
    if (!(shot.ball.body.radius > 0) || shot.until.length) continue;
    const Trajectory one = simulate(shot);
    const Vec2d size = shot.table.highest(), low = shot.table.lowest();
    Ball other{{r.uniform(low.x, size.x), r.uniform(low.y, size.y)}, {shot.ball.body.radius / 4, 0.1}, "1"};
    if (!std::holds_alternative<SlideRoll>(shot.physics.motion) ||
        Boundary(shot.table, other.body).clearance(other.at) < 0 ||
        norm(other.at - shot.ball.at) < 2 * shot.ball.body.radius)
      continue;
    if (auto* han = std::get_if<Han2005>(&shot.physics.cushion); han && !(han->height < 2 * other.body.radius))
      other.body = shot.ball.body;
    if (Boundary(shot.table, other.body).clearance(other.at) < 0) continue;
    shot.others = {other};
    const Trajectory two = simulate(shot);
    if (std::ranges::any_of(two.events, [](const Record& e) { return e.kind == EventKind::ball; })) continue;
    ++alone;
    std::vector<Record> own;
    std::ranges::copy_if(two.events, std::back_inserter(own), [](const Record& e) { return e.ball == 0; });
    INFO("number " << i << " of seed 43: " << write_shot(shot));
    // A pocketed ball ends at its fall in both.
    REQUIRE(own.size() == one.events.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      REQUIRE(own[k].kind == one.events[k].kind);
      REQUIRE(own[k].contact == one.events[k].contact);
      REQUIRE(own[k].state.at == one.events[k].state.at);
      REQUIRE(own[k].state.velocity == one.events[k].state.velocity);
      REQUIRE(own[k].state.spin == one.events[k].state.spin);
    }
    REQUIRE(two.length == one.length);
    REQUIRE(two.end == one.end);
  }
  CHECK(alone > 100);
}

namespace {

void check(const ShotRequest& shot, const Watched& w) {
  INFO(write_shot(shot));
  CHECK(w.ended);
  CHECK(w.overlap <= 1e-12 + (w.meetings == 0 ? tolerance::overlap : 0));
  CHECK(w.gained <= 1e-12);
}

}  // namespace

namespace {

void try_families(int shots, std::uint64_t seed) {
  for (const BallFamily family : ball_families) {
    Random r(seed);
    long events = 0, meetings = 0, most = 0;
    for (int i = 0; i < shots; ++i) {
      const ShotRequest shot = random_balls(r, family);
      const Watched w = watched(shot);
      INFO(name(family) << " number " << i << " of seed " << seed);
      check(shot, w);
      events += w.events, meetings += w.meetings, most = std::max(most, w.events);
    }
    std::printf("%s: %ld events, %ld between balls, at most %ld in a shot\n", name(family).c_str(), events, meetings,
                most);
    CHECK(2 * meetings > shots);
  }
}

void try_breaks(int breaks, std::uint64_t seed) {
  Random r(seed);
  for (int i = 0; i < breaks; ++i) {
    const double gaps[] = {0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4};
    const ShotRequest shot = break_shot(r, gaps[i % 6]);
    INFO("number " << i << " of seed " << seed);
    check(shot, watched(shot));
    REQUIRE(to_json(shot, simulate(shot)) == to_json(shot, simulate(shot)));
  }
}

}  // namespace

TEST_CASE("many balls never overlap, gain no energy, and every shot ends") { try_families(40, 47); }
TEST_CASE("thousands of shots with many balls", "[.][long]") { try_families(2000, seed_or_fresh(48)); }

TEST_CASE("a ball that is squeezed against a cushion while another touches by the last bit ends") {
  const ShotRequest shot = read_shot(
      R"({"table": {"length": 1, "width": 1, "pockets": [{"name": "bottom-left", "at": [0, 0], "radius": 0.1375},
    {"name": "bottom-middle", "at": [0.5, 0], "radius": 0.15}, {"name": "bottom-right", "at": [1, 0], "radius":
    0.1375}, {"name": "top-left", "at": [0, 1], "radius": 0.1375}, {"name": "top-middle", "at": [0.5, 1],
    "radius": 0.15}, {"name": "top-right", "at": [1, 1], "radius": 0.1375}]}, "physics": {"model": "spin",
    "sliding_friction": 0.2, "rolling_friction": 0.01, "spinning_friction": 0.027777777777777776, "g": 9.81,
    "cushion": {"model": "han2005", "restitution": 0.85, "friction": 0.2, "height": 0.08}}, "ball": {"at":
    [0.609375, 0.609375], "radius": 0.0625, "mass": 0.170097}, "others": [{"id": "1", "at": [0.7069692926894066,
    0.48551895751144014]}, {"id": "2", "at": [0.4611891694854644, 0.35768882026292736]}, {"id": "3", "at":
    [0.6467403814799656, 0.9433406659775809], "radius": 0.04954655640869536}, {"id": "4", "at":
    [0.5436261123931495, 0.7483786716768211]}, {"id": "5", "at": [0.6039123935426177, 0.25938818874807146]},
    {"id": "6", "at": [0.2343951387913148, 0.4661258193286082]}, {"id": "7", "at": [0.9214349833014723,
    0.6046244927415529]}], "shot": {"speed": 0.9923135820033048, "angle": 359.93425012874667, "spin": {"top":
    0.669929736722972, "side": 0.0726024777772043, "masse": 0}}})");
  const Trajectory t = simulate(shot);
  CHECK(t.end == EventKind::rest);
  CHECK(t.events.size() < 20000);
}

TEST_CASE("a small ball that keeps no speed across a jaw's tip leaves it") {
  const Trajectory t = simulate(read_shot(
      R"({"ball": {"at": [1.9314382025404537, 0.32430676770243777], "mass": 0.16853258142428862, "radius": 0.028575,
    "spin": {"masse": 0, "side": 0.6932732192215723, "top": 0.29489170642838314}}, "others": [{"at":
    [1.576703518359437, 0.8910243211334714], "id": "1", "mass": 0.05707793553569278, "radius":
    0.02044924365977583}], "physics": {"ball_ball": {"friction": 0.0657846616578331, "restitution":
    0.40722393895089726}, "cushion": {"friction": 0.2, "height": 0.036576, "model": "han2005", "restitution":
    0.85}, "g": 9.81, "model": "spin", "rolling_friction": 0.01, "sliding_friction": 0.2, "spinning_friction":
    0.0127}, "shot": {"angle": 122.9807574291798, "speed": 4.1988748452580875}, "table": "pool-9ft"})"));
  CHECK(t.end == EventKind::pocket);
  CHECK(t.events.size() < 100);
}

TEST_CASE("a ball that creeps into a wedge between two that rest comes to rest there") {
  const Trajectory t = simulate(read_shot(
      R"({"ball": {"at": [2.122899280484913, 1.2177728997715371], "mass": 0.1406, "radius": 0.02625, "spin":
    {"masse": 0, "side": 0, "top": -0.7858955800634647}}, "others": [{"at": [2.076839057702405,
    1.2429662694791759], "id": "1", "mass": 0.1406, "radius": 0.02625}, {"at": [2.169102128318139,
    1.1928420583876376], "id": "2", "mass": 0.1406, "radius": 0.02625}, {"at": [2.195352128318139,
    1.1473757246889544], "id": "3", "mass": 0.1406, "radius": 0.02625}, {"at": [2.10296870864903,
    1.288501874684487], "id": "4", "mass": 0.1406, "radius": 0.02625}, {"at": [2.168770651717781,
    1.1021023870414535], "id": "5", "mass": 0.1406, "radius": 0.02625}, {"at": [1.1325340176892111, 0.02625],
    "id": "6", "mass": 0.1406, "radius": 0.02625}, {"at": [0.6821128607864784, 0.17301931648031926], "id": "7",
    "mass": 0.1406, "radius": 0.02625}, {"at": [2.050589057702384, 1.1974999357804563], "id": "8", "mass":
    0.1406, "radius": 0.02625}, {"at": [2.938329606388654, 0.02625], "id": "9", "mass": 0.1406, "radius":
    0.02625}], "physics": {"cushion": {"friction": 0.2, "height": 0.03675, "model": "han2005", "restitution":
    0.85}, "g": 9.81, "model": "spin", "rolling_friction": 0.01, "sliding_friction": 0.2, "spinning_friction":
    0.011666666666666665}, "shot": {"angle": 114.73480027766333, "speed": 2.283901948338262e-05}, "table":
    "snooker-12ft"})"));
  CHECK(t.end == EventKind::rest);
  CHECK(t.events.size() < 1000);
}

TEST_CASE("breaks: no overlap, no energy gained, all end, the same bytes twice") { try_breaks(30, 53); }
TEST_CASE("two thousand breaks", "[.][long]") { try_breaks(2000, seed_or_fresh(54)); }

TEST_CASE("balls that crowd together after a break neither come to rest nor bounce again and again") {
  constexpr std::size_t breaks = 60;
  constexpr std::uint64_t seed = 53;
  Random r(seed);
  std::size_t events = 0;
  for (std::size_t i = 0; i < breaks; ++i) {
    const Trajectory t = simulate(break_shot(r, i % 2 == 0 ? 0 : 1e-9));
    events += t.events.size();
    std::map<int, int> rests;
    for (const Record& e : t.events)
      if (e.kind == EventKind::rest) ++rests[e.ball];
    INFO("number " << i << " of seed " << seed);
    for (const auto& [ball, times] : rests) CHECK(times < 30);  // far above the usual count
  }
  CHECK(events / breaks < 200);  // balls that crowd and bounce again and again exceed this
}

TEST_CASE("two balls that stay in touch while one goes round the other do not bounce off each other") {
  const Body ball{};
  const Boundary boundary(rectangle_table(40, 20), ball);
  // The first ball has topspin, which drives it into the second.
  const std::array balls{
      BallStart<double>{&boundary, {{10, 10}, {0.1, 0.02}, {-0.02 / ball.radius, 1 / ball.radius, 0}}},
      BallStart<double>{&boundary, {{10 + 2 * ball.radius, 10}, {0.1, 0}, {0, 0.1 / ball.radius, 0}}}};
  ManyBalls sim(std::span<const BallStart<double>>(balls), SlideRoll{}, Han2005{}, BallBall{});
  int meetings = 0;
  double apart = 0;
  while (sim.time() < 0.15) {  // later the first ball rolls
    const BallEvent e = sim.step(std::min(1e-3, 0.15 - sim.time()));
    meetings += e.event.kind == EventKind::ball;
    apart = std::max(apart, std::abs(norm(sim.state_now(1).at - sim.state_now(0).at) - 2 * ball.radius));
  }
  CHECK(meetings == 0);
  CHECK(apart < tolerance::held_gap);
}

TEST_CASE("of many balls the first events are those of 50 digits") {
  // A rounding error grows as the effect of turning the launch by an angle of that size.
  constexpr std::uint64_t seed = 59;
  constexpr double turn = 1e-16, grain = 1e-15, most = 100;
  int compared = 0, ties = 0, by_touching = 0;
  double worst = 0;
  for (const BallFamily family : {BallFamily::scattered, BallFamily::sizes, BallFamily::elastic, BallFamily::rolling}) {
    Random r(seed);
    for (int i = 0; i < 25; ++i) {
      const ShotRequest shot = random_balls(r, family);
      const auto exact = truth::run_many_truth(shot, 25), turned = truth::run_many_truth(shot, 25, turn);
      const auto plain = truth::run_many_double(shot, 25);
      for (std::size_t k = 0; k < std::min({exact.size(), turned.size(), plain.size()}); ++k) {
        if (plain[k].event.ball != exact[k].event.ball || plain[k].event.event.kind != exact[k].event.event.kind) {
          ++ties;  // rounding orders two events that are so near each other
          break;
        }
        INFO(name(family) << " number " << i << " of seed " << seed << ", event " << k << ": " << write_shot(shot));
        const double grown = norm(turned[k].at - exact[k].at) + grain, off = norm(plain[k].at - exact[k].at);
        ++compared;
        // Balls within the touching tolerance meet at once, and rounding may put a gap on either side of it.
        const double touch = Boundary(shot.table, shot.ball.body).touch;
        const bool snapped = off > most * grown;
        by_touching += snapped;
        if (!snapped) worst = std::max(worst, off / grown);
        CHECK(off <= std::max(most * grown, most * touch));
      }
    }
  }
  std::printf(
      "%d events of many balls against 50 digits: off by %.3g times what a turn by 1e-16 does, %d more by a\n"
      "touching gap, %d ties\n",
      compared, worst, by_touching, ties);
  CHECK(by_touching < compared / 20);
  CHECK(compared > 500);
  CHECK(ties < 10);
}
