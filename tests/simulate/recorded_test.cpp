// SPDX-License-Identifier: MIT
//
// Lengths of paths against closed forms, recorded shots of many balls, the lag speed, and shots played again.
#include <cmath>

#include "bankshot/scene/scene.hpp"
#include "sim/plan/played.hpp"
#include "sim/simulate/lag.hpp"
#include "sim/simulate/path_length.hpp"
#include "sim/simulate/record_many.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

/// A ball that rolls on a table of 3 m by 2 m.
ShotRequest rolling_shot(double speed, double angle = 0) {
  return {.table = rectangle_table(3, 2), .ball = {.at = {1, 1}}, .launch = {speed, angle}};
}

}  // namespace

TEST_CASE("the length of a parabola is that of its closed form") {
  // v = (1, a t) with a = 2: the length is (a t √(1 + a²t²) + asinh(a t)) / 2a.
  const Arc<double> arc{{}, {1, 0}, {0, 2}, 10, PhaseEnd::roll, true};
  for (const double t : {1e-9, 0.3, 5.0}) {
    const double x = 2 * t;
    CHECK(length(arc, t) == Approx((x * std::sqrt(1 + x * x) + std::asinh(x)) / 4).epsilon(1e-14));
  }
  // With hardly any acceleration it is speed times time.
  const Arc<double> nearly{{}, {3, 4}, {1e-14, 0}, 10, PhaseEnd::roll, true};
  CHECK(length(nearly, 2) == Approx(10).epsilon(1e-14));
  // A ball that comes back covers the way twice.
  const Arc<double> back{{}, {1, 0}, {-1, 0}, 10, PhaseEnd::roll, true};
  CHECK(length(back, 2) == Approx(1).epsilon(1e-14));
}

TEST_CASE("the time at a length inverts the length, leg by leg") {
  const Arc<double> even{{}, {2, 0}, {}, 1, PhaseEnd::none}, bent{{2, 0}, {2, 0}, {0, 1}, 3, PhaseEnd::roll, true};
  const std::vector<Leg> legs{{0.5, 1, even, {}}, {1.5, 3, bent, {}}};
  CHECK(time_to_length(legs, 1) == Approx(0.5).epsilon(1e-15));
  const double later = time_to_length(legs, 4);
  CHECK(later > 1);
  CHECK(2 + length(bent, later - 1) == Approx(4).epsilon(1e-14));
  CHECK(time_to_length(legs, 100) == forever);
}

TEST_CASE("two equal balls that meet head on exchange their speeds up to the restitution") {
  ShotRequest r = rolling_shot(1);
  const double gap = 0.5;
  r.others = {{{1 + 2 * r.ball.body.radius + gap, 1}, r.ball.body, "1"}};
  const Trajectory t = record_many(r);
  const auto hit = std::ranges::find(t.events, EventKind::ball, &Record::kind);
  REQUIRE(hit != t.events.end());
  const double a = deceleration(r.physics), at_hit = std::sqrt(1 - 2 * a * gap), e = r.physics.ball_ball.restitution;
  CHECK(hit->time == Approx((1 - at_hit) / a).epsilon(1e-13));
  CHECK(hit->state.velocity.x == Approx((1 - e) / 2 * at_hit).epsilon(1e-12));
  CHECK(hit->other.velocity.x == Approx((1 + e) / 2 * at_hit).epsilon(1e-12));
  // Each ball has a start and an end; all times are in order.
  CHECK(std::ranges::count(t.events, EventKind::start, &Record::kind) == 2);
  CHECK(std::ranges::count(t.events, EventKind::end, &Record::kind) == 2);
  CHECK(std::ranges::is_sorted(t.events, {}, &Record::time));
}

TEST_CASE("a recording ends at the time, the cushions or the length asked") {
  ShotRequest r = rolling_shot(3);
  r.others = {{{0.5, 0.5}, r.ball.body, "1"}};
  r.until.time = 0.25;
  CHECK(record_many(r).events.back().time == 0.25);
  r.until = {.time = {}, .cushions = 2, .length = {}};
  CHECK(record_many(r).cushions == 2);
  r.until = {.time = {}, .cushions = {}, .length = 4};
  CHECK(record_many(r).length == Approx(4).epsilon(1e-12));
  r.launch.speed = 0;
  CHECK(record_many(r).end == EventKind::rest);
}

TEST_CASE("the lag speed rolls the length of the table and back") {
  ShotRequest r = rolling_shot(1);
  const double R = r.ball.body.radius, a = deceleration(r.physics), e = restitution(r.physics).at_rest;
  // Backwards from the second cushion, which it reaches with no speed: v1² = 2 a (3 − 2R) before, v1 / e at the first.
  const double after2 = 2 * a * (3 - 2 * R), before2 = after2 / (e * e), launch2 = before2 + 2 * a * (3 - R - 0.75);
  const auto found = lag_speed(r);
  REQUIRE(found);
  CHECK(*found == Approx(std::sqrt(launch2)).margin(20 * std::pow(0.5, 19)));
  r.launch = {7, 2};
  r.others = {{{2, 1}, r.ball.body, "1"}};
  CHECK(lag_speed(r) == found);  // launch and other balls do not matter
  r.physics = ideal_physics();
  CHECK(!lag_speed(r));
  r = rolling_shot(1);
  r.table = polygon_table({{0, 0}, {3, 0}, {0, 2}});
  CHECK(!lag_speed(r));
}

TEST_CASE("a shot that is played again arrives where its simulation does") {
  Puzzle p;
  p.table = rectangle_table(3, 2);
  p.ball.at = {1, 1};
  p.target = PointTarget{{2, 1}};
  p.arrive = Range{0, 0};
  Shot shot;
  const double a = deceleration(p.physics);
  shot.launch = {std::sqrt(2 * a), 0};  // rests after one metre
  shot.path.arrival = {std::sqrt(2 / a), 0, {2, 1}};
  const State<double> there = state_on_arrival(p, shot);
  CHECK(norm(there.at - Vec2d{2, 1}) < 1e-12);
  CHECK(norm(there.velocity) < 1e-7);
  double last = -1;
  int seen = 0;
  sample_played(p, shot, [&](double time, int ball, const State<double>& s) {
    CHECK(ball == 0);
    CHECK(time >= last);
    CHECK(s.at.x == Approx(1 + shot.launch.speed * time - a * time * time / 2).epsilon(1e-12));
    last = time;
    ++seen;
  });
  CHECK(last == Approx(shot.path.arrival.time).epsilon(1e-9));
  CHECK(seen >= static_cast<int>(usual_rate * last));
}
