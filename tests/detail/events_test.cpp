// SPDX-License-Identifier: MIT
//
// The parts that find what an arc meets first: contacts that the centre is on, the event finder, and times on paths of
// which an arc is the chord.
#include <array>
#include <cmath>
#include <utility>

#include "bankshot/detail/next_event.hpp"
#include "bankshot/detail/on_cushions.hpp"
#include "bankshot/detail/on_path.hpp"
#include "bankshot/motion/tilted.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/table.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::detail;

namespace {

const Body ball{.radius = 0.125};
const Table table = rectangle_table(3, 2);

/// Returns a straight arc without friction.
Arc<double> straight(const Vec2d& at, const Vec2d& velocity) { return {at, velocity, {0, 0}, forever, PhaseEnd::none}; }

NextEvent<double> next(const Boundary& boundary, const Arc<double>& arc, double horizon = forever) {
  const OnCushions<double> cushions(dot(arc.velocity, arc.velocity));
  return EventFinder<false, double>{boundary, cushions, arc}.next(horizon);
}

}  // namespace

TEST_CASE("the first cushion, its time and its end are found") {
  const Boundary b(table, ball);
  const auto right = next(b, straight({0.5, 1}, {2, 0}));
  CHECK(right.event.kind == EventKind::cushion);
  CHECK(right.event.contact == Contact::rail(1));
  CHECK(right.time == 1.1875);  // 3 − 0.125 − 0.5 metres at 2 m/s
  CHECK(!right.second);
  const auto stopped = next(b, straight({0.5, 1}, {2, 0}), 1);
  CHECK(stopped.event.kind == EventKind::horizon);
  CHECK(stopped.time == 1);
  CHECK(!stopped.piece);
}

TEST_CASE("a ball that runs into a corner meets two cushions at once") {
  const auto corner = next(Boundary(table, ball), straight({0.625, 0.625}, {-1, -1}));
  CHECK(corner.time == 0.5);
  CHECK(corner.event.contact == Contact::rail(0));
  CHECK(corner.second == Contact::rail(3));
}

TEST_CASE("an arc that ends before it meets anything ends in its own way") {
  const Boundary b(table, ball);
  const std::array ends{std::pair(PhaseEnd::roll, EventKind::slide_to_roll), std::pair(PhaseEnd::rest, EventKind::rest),
                        std::pair(PhaseEnd::piece, EventKind::horizon)};
  for (const auto& [end, kind] : ends) {
    Arc<double> arc = straight({1, 1}, {0.5, 0});
    arc.duration = 0.25;
    arc.end = end;
    const auto found = next(b, arc);
    CHECK(found.event.kind == kind);
    CHECK(found.time == 0.25);
    CHECK(found.piece == (end == PhaseEnd::piece));
  }
}

TEST_CASE("a pocket captures before a ball, and a ball bounces before a cushion") {
  const std::array others{Ball{{1.5, 1}, ball, "1"}, Ball{{1.5, 1.5}, ball, "2"}};
  Table with = table;
  const auto first = [&] { return next(Boundary(with, ball, others), straight({0.5, 1}, {1, 0})); };
  const auto met = first();
  CHECK(met.event.kind == EventKind::ball);
  CHECK(met.event.contact == Contact::ball(1));
  CHECK(met.time == 0.75);  // the centres are two radii apart
  with.pockets = {{"hole", {1.5, 1}, 0.25}};
  CHECK(first().event.kind == EventKind::pocket);
  CHECK(first().time == 0.75);
  // A ball and a cushion in one instant.
  const std::array at_rail{Ball{{2.875, 1.5}, ball, "1"}};
  const auto both = next(Boundary(table, ball, at_rail), straight({2.125, 0.25}, {0.75, 1}));
  CHECK(both.event.kind == EventKind::ball);
  CHECK(both.time == 1);
}

TEST_CASE("the time of an event carries the derivatives of its arc") {
  const Boundary b(table, ball);
  Arc<Dual<2>> arc;
  arc.at = {Dual<2>(0.5, 0), Dual<2>(1)};
  arc.velocity = {Dual<2>(2, 1), Dual<2>(0)};
  arc.duration = Dual<2>(forever);
  const auto found = next(b, value(arc));
  const Dual<2> t = lift_event(b, found, arc, false, Dual<2>(forever));
  CHECK(t.a == found.time);
  CHECK(t.v[0] == Approx(-0.5).epsilon(1e-15));             // a metre nearer at 2 m/s
  CHECK(t.v[1] == Approx(-found.time / 2).epsilon(1e-15));  // t = distance / speed
}

TEST_CASE("a ball that starts against cushions is put on their lines, once each") {
  const Boundary b(table, ball);
  OnCushions<double> on(1);
  Vec2d centre{0.125 + 1e-13, 0.125 - 1e-13};
  on.settle_at_start(b, centre);
  CHECK(centre == Vec2d{0.125, 0.125});
  CHECK(on.on(Contact::rail(0)));
  CHECK(on.on(Contact::rail(3)));
  CHECK(on.on_rail());
  CHECK(!on.any_holds());
  on.leave();
  CHECK(!on.on_rail());
  Vec2d away{0.125 + 1e-6, 1};
  on.settle_at_start(b, away);
  CHECK(away.x == 0.125 + 1e-6);
  CHECK(!on.on_rail());
}

TEST_CASE("the last contact comes first, and one that is met twice is kept once") {
  OnCushions<double> on(1);
  on.meet(Contact::rail(2));
  on.meet(Contact::rail(2));
  CHECK(on.at(0) == Contact::rail(2));
  CHECK(!on.at(1));
  on.meet(Contact::rail(1));
  CHECK(on.at(0) == Contact::rail(1));
  CHECK(on.at(1) == Contact::rail(2));
  on.hold(Contact::rail(2));
  on.leave();  // what holds the ball stays, and comes first
  CHECK(on.at(0) == Contact::rail(2));
  CHECK(!on.at(1));
  CHECK(on.held(Contact::rail(2)));
}

TEST_CASE("a push away from a cushion ends its hold, and a push along it does not") {
  const Boundary b(table, ball);
  for (const auto& [push, holds] : {std::pair(Vec2d{1, 0}, true), std::pair(Vec2d{1, -1}, true),
                                    std::pair(Vec2d{1, 1e-3}, false), std::pair(Vec2d{1, 1e-17}, true)}) {
    OnCushions<double> on(1);
    on.meet(Contact::rail(0));
    on.hold(Contact::rail(0));
    on.let_go(b, {1, 0.125}, push);
    CHECK(on.any_holds() == holds);
  }
}

TEST_CASE("friction that drives a ball into its cushion holds it there, if it has hardly any speed away") {
  const Boundary b(table, ball);
  const auto held = [&](double away, double pull) {
    OnCushions<double> on(1);
    on.meet(Contact::rail(0));
    Arc<double> arc{{1, 0.125}, {0.5, away}, {-1, pull}, 0.1, PhaseEnd::roll, true};
    on.hold(b, arc);
    if (on.any_holds()) {
      CHECK(arc.velocity.y == 0);
      CHECK(arc.acceleration.y == 0);
    } else {
      CHECK(arc.velocity.y == away);
      CHECK(arc.acceleration.y == pull);
    }
    return on.any_holds();
  };
  CHECK(held(0, -1));
  CHECK(held(tolerance::resting / 2, -1));
  CHECK(!held(tolerance::resting * 2, -1));
  CHECK(!held(0, 1));
  CHECK(!held(tolerance::resting / 2, -tolerance::resting));  // too weak to bring it back
}

TEST_CASE("speeds count as rounding by the last bounce, and as rest by the launch") {
  OnCushions<double> on(4);
  CHECK(on.is_rounding(1e-32));
  on.bounces(1e-6);  // a slow bounce rounds less
  CHECK(!on.is_rounding(1e-32));
  CHECK(on.is_still(1e-200));
  CHECK(!on.is_still(1e-198));
}

TEST_CASE("a time on a chord becomes the time on the path") {
  // The path's gap is 1 − t², and its chord from 0 to 2 met the line at 0.8.
  const auto gap = [](double t) { return std::pair(1 - t * t, 2 * t); };
  const auto same = [](double t) { return t; };
  CHECK(time_on_path(0.8, 0.0, 2.0, same, gap) == Approx(1).epsilon(1e-15));
  CHECK(time_on_path(1.3, 0.0, 2.0, same, gap) == Approx(1).epsilon(1e-15));
  // A gap that opens all the time is met by the chord alone.
  CHECK(time_on_path(0.8, 0.0, 2.0, same, [](double t) { return std::pair(1 + t, -1.0); }) == 0.8);
}

TEST_CASE("an arc that is its own path keeps its times") {
  const Boundary b(table, ball);
  const State<double> start{{0.5, 1}, {2, 0}, {}};
  TiltedOf<double> motion{};
  motion.rise = {0.01, 0};
  Arc<double> arc = motion.arc(ball, start);
  arc.chord = false;
  CHECK(time_on_path(motion, b, start, arc, Contact::rail(1), false, false, 1.2) == 1.2);
}

TEST_CASE("on a leaning table the ball touches the rail at the time that is found") {
  const Boundary b(table, ball);
  TiltedOf<double> motion{};
  motion.rise = {0.01, 0.02};
  const State<double> start{{0.5, 1}, {2, -0.3}, {0, 2 / ball.radius, 0}};
  const Arc<double> arc = motion.arc(ball, start);
  REQUIRE(arc.chord);
  const double there = arc.duration * 0.7;
  const State<double> at = advance(motion, ball, start, arc, there);
  // A rail at just this place: the chord meets it at another time than the path.
  Boundary moved = b;
  moved.walls[1].offset = -at.at.x;
  const double chord = first_descent(-arc.at.x - moved.walls[1].offset, -arc.velocity.x, -arc.acceleration.x);
  const double path = time_on_path(motion, moved, start, arc, Contact::rail(1), false, false, chord);
  CHECK(path == Approx(there).epsilon(1e-13));
  CHECK(lift_on_path(motion, moved, start, arc, Contact::rail(1), false, false, chord) == path);
}
