// SPDX-License-Identifier: MIT
//
// Balls in play, the pairs of them that cannot meet, and the forces between those that press on each other.
#include "bankshot/detail/balls_in_play.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "bankshot/detail/lasting.hpp"
#include "bankshot/detail/pressed.hpp"
#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/scene/table.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::detail;

namespace {

constexpr double g = 9.81, sliding = 0.2;
const Body body{};
const SlideRoll cloth{.sliding_friction = sliding};
const auto unwatched = Unwatched{};

/// Returns balls whose arcs have just begun.
BallsInPlay<double, SlideRoll> balls_of(const Boundary& boundary, const std::vector<State<double>>& states) {
  BallsInPlay<double, SlideRoll> in{.motion = cloth};
  in.rounding = {boundary.touch, 1e-12};
  in.glances.resize(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    in.balls.push_back({BallTrack<double>(boundary, states[i], 1)});
    in.balls.back().awake = squared_scale(states[i], body.radius) > 0;
    in.begin(i);
    in.find(in.balls[i]);
    in.look_at(i);
  }
  return in;
}

/// Returns a ball that stands and spins forward about the axis across `way`.
State<double> spinning(const Vec2d& at, const Vec2d& way) {
  return {at, {0, 0}, {-way.y / body.radius, way.x / body.radius, 0}};
}

}  // namespace

TEST_CASE("a ball in play knows its next event, its highest speed and its bend") {
  const Boundary boundary(rectangle_table(4, 2), body);
  auto in = balls_of(boundary, {{{1, 1}, {2, 0}, {}}, {{3, 1}, {0, 0}, {}}});
  const auto& moving = in.balls[0];
  CHECK(moving.moves);
  CHECK(moving.next.event.kind == EventKind::slide_to_roll);
  CHECK(moving.due == Approx(2 * 2 / (7 * sliding * g)).epsilon(1e-14));
  CHECK(moving.fastest == 2);
  CHECK(moving.bend == Approx(sliding * g));
  CHECK(in.stands(in.balls[1].track.arc()));
  CHECK(in.count() == 2);
  in.now = 0.1;
  in.bring(0, unwatched);
  CHECK(in.balls[0].began == 0.1);
  CHECK(in.balls[0].track.state().velocity.x == Approx(2 - 0.1 * sliding * g).epsilon(1e-15));
}

TEST_CASE("two balls that cannot meet before one is due are told from their speeds") {
  const Boundary boundary(rectangle_table(40, 2), body);
  auto in = balls_of(boundary, {{{1, 1}, {2, 0}, {}}, {{1.2, 1}, {0, 0}, {}}, {{30, 1}, {0, 0}, {}}});
  CHECK(!in.stay_apart(0, 1));
  CHECK(in.stay_apart(0, 2));
  CHECK(in.are_apart(0, 1));
  CHECK(in.reach(0, 1) == Approx(2 * body.radius).epsilon(1e-15));
  const auto seen = in.seen(0, 1, 0);
  CHECK(seen.at == Vec2d{1.2, 1} - Vec2d{1, 1});
  CHECK(seen.velocity == Vec2d{-2, 0});
  const auto touching = balls_of(boundary, {{{1, 1}, {2, 0}, {}}, {{1 + 2 * body.radius, 1}, {0, 0}, {}}});
  CHECK(!touching.are_apart(0, 1));
}

TEST_CASE("the highest speed on an arc is at one of its ends") {
  using In = BallsInPlay<double, SlideRoll>;
  Arc<double> arc{{}, {3, 0}, {-1, 1}, 10, PhaseEnd::roll, true};
  CHECK(In::fastest_on(arc, 1) == 3);
  CHECK(In::fastest_on(arc, 8) == Approx(std::hypot(5.0, 8.0)));
  arc.bends = false;
  CHECK(In::fastest_on(arc, 8) == 3);
}

TEST_CASE("a rolling ball that hardly moves comes to rest, and a faster one goes on") {
  const Boundary boundary(rectangle_table(4, 2), body);
  constexpr double slow = tolerance::slow_contact * tolerance::pressed_rest;
  for (const double speed : {slow * 0.9, slow * 1.1}) {
    auto in = balls_of(boundary, {{{1, 1}, {speed, 0}, {0, speed / body.radius, 0}}});
    in.slow_to_rest(in.balls[0]);
    CHECK((norm(in.balls[0].track.state().velocity) == 0) == (speed < slow));
  }
}

TEST_CASE("a ball that spins against one at rest shares its friction with seven fifths of the other") {
  const Boundary boundary(rectangle_table(4, 2), body);
  auto in = balls_of(boundary, {spinning({1, 1}, {1, 0}), {{1 + 2 * body.radius, 1}, {0, 0}, {}}});
  LastingContacts<double, SlideRoll> contacts(1);
  std::vector<std::size_t> changed{0, 1};
  contacts.let_go(in, changed, unwatched);
  contacts.hold(in, changed, unwatched);
  CHECK(contacts.is_held(0, 1));
  CHECK(contacts.is_held(1, 0));
  // The friction μ m g moves the masses m and 7/5 m; the resting ball's rolling friction is overcome by the push.
  const double together = sliding * g / 2.4;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(in.balls[i].track.arc().acceleration.x == Approx(together).epsilon(1e-13));
    CHECK(in.balls[i].track.arc().end == PhaseEnd::piece);
  }
  changed = {0};
  contacts.let_go(in, changed, unwatched);
  CHECK(!contacts.is_held(0, 1));
  CHECK(changed == std::vector<std::size_t>{0, 1});  // the other ball needs a new arc too
}

TEST_CASE("balls that friction drives apart are not held") {
  const Boundary boundary(rectangle_table(4, 2), body);
  auto in = balls_of(boundary, {spinning({1, 1}, {-1, 0}), {{1 + 2 * body.radius, 1}, {0, 0}, {}}});
  LastingContacts<double, SlideRoll> contacts(1);
  std::vector<std::size_t> changed{0, 1};
  contacts.let_go(in, changed, unwatched);
  contacts.hold(in, changed, unwatched);
  CHECK(!contacts.is_held(0, 1));
  CHECK(in.balls[0].track.arc().acceleration.x == Approx(-sliding * g).epsilon(1e-14));
}

TEST_CASE("the speed at which balls stay together is a thousandth of the launch, up to a limit") {
  CHECK(LastingContacts<double, SlideRoll>(1e-3).slowest_meeting() == Approx(1e-6));
  CHECK(LastingContacts<double, SlideRoll>(5).slowest_meeting() == tolerance::held_contact);
}

TEST_CASE("a push moves the mass of a sliding ball, and seven fifths of a rolling or resting one") {
  const Arc<double> slides_now{{}, {1, 0}, {-2, 0}, 0.1, PhaseEnd::roll, true};
  const Arc<double> rolls_now{{}, {1, 0}, {-0.1, 0}, 10, PhaseEnd::rest};
  CHECK(slides(slides_now));
  CHECK(!slides(rolls_now));
  CHECK(inertia(slides_now, body) == body.mass);
  CHECK(inertia(rolls_now, body) == Approx(1.4 * body.mass).epsilon(1e-15));
}

TEST_CASE("friction that grows with the speed counts where an arc begins") {
  Arc<double> arc{{}, {0, 2}, {0, 0}, 1, PhaseEnd::rest};
  arc.drag = {0.1, 0.05};
  CHECK(norm(first_acceleration(arc) - Vec2d{0, -0.2}) < 1e-16);
}

TEST_CASE("friction turns as fast as the slip or the line of travel does") {
  const Arc<double> rolls_now{{}, {2, 0}, {-0.1, 0}, 20, PhaseEnd::rest};
  CHECK(friction_turns(rolls_now, Vec2d{0, 0.5}) == Approx(0.25));  // across 2 m/s
  CHECK(friction_turns(rolls_now, Vec2d{0.5, 0}) == 0);
  CHECK(friction_turns(rolls_now, Vec2d{0, 0}) == 0);
  const double lasts = 0.1;  // a slip of 7/2 · 2 m/s² · 0.1 s = 0.7 m/s
  const Arc<double> slides_now{{}, {2, 0}, {-2, 0}, lasts, PhaseEnd::roll, true};
  CHECK(friction_turns(slides_now, Vec2d{0, 0.5}) == Approx(0.5 / 0.7));
}

TEST_CASE("a pressed arc is a piece with the push added") {
  Arc<double> rolling{{}, {1, 0}, {-0.1, 0}, 10, PhaseEnd::rest};
  press(rolling, Vec2d{-0.9, 0}, 2e-3);
  CHECK(rolling.acceleration == Vec2d{-1, 0});
  CHECK(rolling.duration == 2e-3);
  CHECK(rolling.pressed == Press::rolls);
  CHECK(rolling.end == PhaseEnd::piece);
  Arc<double> soon{{}, {1e-3, 0}, {-0.1, 0}, 0.01, PhaseEnd::rest};
  press(soon, Vec2d{-0.9, 0}, 2e-3);
  CHECK(soon.duration == Approx(1e-3));  // it halts before the piece ends
  Arc<double> sliding_arc{{}, {1, 0}, {-2, 0}, 0.1, PhaseEnd::roll, true};
  press(sliding_arc, Vec2d{0, 1}, 2e-3);
  CHECK(sliding_arc.pressed == Press::slides);
  CHECK(sliding_arc.acceleration + sliding_arc.taken == Vec2d{-2, 0});  // friction turns the ball as before
}

TEST_CASE("a single contact is exact at once, and a cushion takes any push") {
  std::vector<Pressed<double>> contacts{{0, 1, {1, 0}}, {1, Pressed<double>::none, {1, 0}}};
  std::vector<Vec2d> rates{{3, 0.5}, {0, 0}};
  const std::vector<double> masses{0.5, 0.25};
  REQUIRE(Forces<double>(contacts, rates, masses).settle(200).settled);
  CHECK(contacts[0].force == Approx(1.5));  // all of m a goes through the second ball into the cushion
  CHECK(contacts[1].force == Approx(1.5));
  CHECK(norm(rates[0] - Vec2d{0, 0.5}) < 1e-14);
  CHECK(norm(rates[1]) < 1e-14);
  CHECK(parting_rate<double>(contacts[0], rates) == Approx(0).margin(1e-14));
}
