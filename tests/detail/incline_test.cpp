// SPDX-License-Identifier: MIT
//
// Motion under friction: on an incline, against closed forms and a fine integration, and along a cushion that holds
// the ball.
#include "bankshot/detail/incline.hpp"

#include <array>
#include <cmath>

#include "bankshot/detail/held.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::detail;

namespace {

constexpr double g = 9.81;

Vec2d direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Draws an incline on which a ball comes to rest.
Incline<double> random_incline(Random& r, bool drags) {
  const double friction = r.uniform(0.05, 2);
  return {friction, drags ? r.uniform(0.01, 0.5) : 0, friction * r.uniform(0.01, 0.9), direction_of(r.uniform(0, 6))};
}

/// Returns the velocity after `seconds` by Runge and Kutta's method of order four.
Vec2d integrated(const Incline<double>& law, Vec2d w, double seconds) {
  constexpr int steps = 4000;
  const double h = seconds / steps;
  const auto rate = [&](const Vec2d& v) { return law.down * law.pull - v * (law.friction / norm(v) + law.drag); };
  for (int i = 0; i < steps; ++i) {
    const Vec2d a = rate(w), b = rate(w + a * (h / 2)), c = rate(w + b * (h / 2)), d = rate(w + c * h);
    w += (a + b * 2.0 + c * 2.0 + d) * (h / 6);
  }
  return w;
}

}  // namespace

TEST_CASE("a ball across a slope rests after the time and at the place of the worked number") {
  const Incline<double> law{0.0981, 0, 5.0 / 7 * g * 0.002, {0, -1}};
  const Vec2d w{1, 0};
  const Stop<double> stop = stop_on(law, w);
  const Vec2d moved = stop.beyond + w * stop.time;
  CHECK(stop.time == Approx(10.406).margin(5e-4));
  CHECK(moved.x == Approx(5.123).margin(5e-4));
  CHECK(moved.y == Approx(-0.372).margin(5e-4));
}

TEST_CASE("straight up and down a slope, friction and pull add or subtract") {
  const Incline<double> law{0.5, 0, 0.2, {0.6, -0.8}};
  for (const double sign : {1.0, -1.0}) {  // downhill, uphill
    const Vec2d w = law.down * (3 * sign);
    const Stop<double> stop = stop_on(law, w);
    const double brakes = law.friction - sign * law.pull;
    CHECK(stop.time == Approx(3 / brakes).epsilon(1e-14));
    const Vec2d moved = stop.beyond + w * stop.time;
    CHECK(dot(law.down, moved) == Approx(sign * 9 / (2 * brakes)).epsilon(1e-13));
    CHECK(std::abs(cross(law.down, moved)) < 1e-13);
  }
  // Uphill, a ball stops even where friction is less than the pull.
  CHECK(stop_on(Incline<double>{0.1, 0, 0.2, {1, 0}}, Vec2d{-3, 0}).time == Approx(10).epsilon(1e-14));
}

TEST_CASE("the two amounts that fade have the square of the third as their product") {
  Random r(82);
  for (int i = 0; i < 1000; ++i) {
    const Incline<double> law = random_incline(r, false);
    const Vec2d w = direction_of(r.uniform(0, 7)) * r.uniform(0.1, 5);
    const Fading<double> f = fading(law, w);
    REQUIRE(f.p * f.n == Approx(f.across * f.across).epsilon(1e-14).margin(1e-300));
    REQUIRE(f.p + f.n == Approx(2 * norm(w)).epsilon(1e-14));
    REQUIRE(f.p - f.n == Approx(2 * dot(law.down, w)).epsilon(1e-13).margin(1e-14));
  }
}

TEST_CASE("the velocity some seconds before the stop needs these seconds to stop") {
  Random r(83);
  for (int i = 0; i < 500; ++i) {
    const Incline<double> law = random_incline(r, false);
    const Vec2d w = direction_of(r.uniform(0, 7)) * r.uniform(0.1, 5);
    const double all = stop_on(law, w).time, left = all * r.uniform(1e-3, 0.999);
    REQUIRE(stop_on(law, before_stop(law, w, left)).time == Approx(left).epsilon(1e-12));
    REQUIRE(norm(before_stop(law, w, all) - w) < 1e-12 * norm(w));
  }
}

TEST_CASE("the power series of the motion agrees with an integration, and with the closed form without drag") {
  Random r(84);
  for (int i = 0; i < 60; ++i) {
    const bool drags = i % 2 == 0;
    const Incline<double> law = random_incline(r, drags);
    const Vec2d w = direction_of(r.uniform(0, 7)) * r.uniform(0.2, 4);
    const Glide<double, double> glide(law, w, 0.5 / (law.friction + law.pull + law.drag * norm(w)));
    const double t = glide.time(0.8);
    REQUIRE(glide.at(t) == Approx(0.8).epsilon(1e-14));
    REQUIRE(glide.time(0.0) == 0);
    REQUIRE(norm(glide.velocity(0.8) - integrated(law, w, t)) < 1e-11 * norm(w));
    if (drags) continue;
    const Stop<double> whole = stop_on(law, w);
    const Vec2d later = before_stop(law, w, whole.time - t);
    REQUIRE(norm(glide.velocity(0.8) - later) < 1e-13 * norm(w));
    const Vec2d beyond = whole.beyond + (w - later) * (whole.time - t) - stop_on(law, later).beyond;
    REQUIRE(norm(glide.beyond(0.8) - beyond) < 1e-12 * norm(w) * whole.time);
  }
}

TEST_CASE("a slip straight into the cushion fades at five halves of the friction") {
  constexpr double friction = 0.2 * g, slip = 1;
  const Vec2d n{0, 1};
  Arc<double> arc{{}, {0.3, 0}, {0, -friction}, slip / (3.5 * friction), PhaseEnd::roll, true};
  hold_slip(arc, n);
  CHECK(arc.end == PhaseEnd::piece);
  CHECK(arc.duration == tolerance::longest_piece);
  CHECK(norm(arc.acceleration) == 0);  // the cushion takes all of the friction
  CHECK(arc.taken == Vec2d{0, -friction});
  // A slip that lasts no longer than the last piece ends with it.
  const double last = tolerance::last_piece / 2;
  Arc<double> ends{{}, {0.3, 0}, {0, -friction}, last * 2.5 / 3.5, PhaseEnd::roll, true};
  hold_slip(ends, n);
  CHECK(ends.end == PhaseEnd::roll);
  CHECK(ends.duration == Approx(last).epsilon(1e-15));
}

TEST_CASE("a cushion takes the friction across it and leaves that along it") {
  Random r(85);
  for (int i = 0; i < 200; ++i) {
    const Vec2d n = direction_of(r.uniform(0, 7)), friction = direction_of(r.uniform(0, 7)) * (0.2 * g);
    Arc<double> arc{{}, perpendicular(n) * r.uniform(0, 2), friction, r.uniform(1e-5, 0.5), PhaseEnd::roll, true};
    hold_slip(arc, n);
    REQUIRE(std::abs(dot(n, arc.acceleration)) < 1e-14);
    REQUIRE(std::abs(cross(n, arc.taken)) < 1e-14);
    REQUIRE(norm(arc.acceleration + arc.taken) == Approx(0.2 * g).epsilon(1e-14));
    REQUIRE(arc.duration <= tolerance::longest_piece);
  }
  // Along the cushion nothing is taken, and the slip fades as if the ball were free.
  Arc<double> along{{}, {1, 0}, {-2, 0}, 1e-3, PhaseEnd::roll, true};
  hold_slip(along, {0, 1});
  CHECK(along.acceleration == Vec2d{-2, 0});
  CHECK(along.duration == Approx(0.5e-3).epsilon(1e-15));
}

TEST_CASE("between two cushions a ball stays, and its slip lasts seven fifths of the time") {
  Arc<double> arc{{1, 1}, {0.1, 0}, {-1, -1}, 0.5, PhaseEnd::roll, true};
  hold_slip_in_corner(arc);
  CHECK(norm(arc.velocity) == 0);
  CHECK(norm(arc.acceleration) == 0);
  CHECK(arc.taken == Vec2d{-1, -1});
  CHECK(arc.duration == Approx(0.7).epsilon(1e-15));
}
