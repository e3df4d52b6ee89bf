// SPDX-License-Identifier: MIT
//
// Persistent contacts of balls: compares the pieces of their paths with a fine integration of the equations, and checks
// the contact forces in clusters. This is hard because friction turns with the slip, the line of centres turns with the
// balls, and a slip may end.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "bankshot/detail/pressed.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

using std::numbers::pi;
constexpr double g = 9.81, sliding = 0.2, rolling = 0.01;

/// Two equal balls that touch: their places, velocities, and the velocities at which their present spin would be
/// rolling.
struct TwoBalls {
  std::array<Vec2d, 2> at, velocity, rolls;
};

State<double> state_of(const TwoBalls& p, std::size_t i, double radius) {
  return {p.at[i], p.velocity[i], {-p.rolls[i].y / radius, p.rolls[i].x / radius, 0}};
}

/// Draws a pair in which neither ball approaches the other; each slides or rolls.
TwoBalls random_pair(Random& r, double radius) {
  const Vec2d n = direction(r.uniform(0, 2 * pi));
  const double speed = std::exp(r.uniform(std::log(0.01), std::log(0.3)));
  TwoBalls p;
  p.at = {Vec2d{10, 5}, Vec2d{10, 5} + n * (2 * radius)};
  p.velocity[0] = direction(r.uniform(0, 2 * pi)) * speed;
  p.velocity[1] = p.velocity[0] + perpendicular(n) * (r.uniform(-0.5, 0.5) * speed);
  for (std::size_t i = 0; i < 2; ++i) {
    p.rolls[i] = p.velocity[i];
    if (r.integer(0, 2) == 0) p.rolls[i] += direction(r.uniform(0, 2 * pi)) * (speed * r.uniform(0.2, 1));
  }
  return p;
}

/// Integrates the equations of motion by Euler's method: sliding, rolling, and a force along the line of centres while
/// it is needed to keep the balls apart.
void follow(TwoBalls& p, double radius, double seconds) {
  constexpr double dt = 2e-6;
  const long steps = std::lround(seconds / dt);
  for (long step = 0; step < steps; ++step) {
    std::array<Vec2d, 2> pull{}, spun{};
    std::array<double, 2> light{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2d slip = p.velocity[i] - p.rolls[i];
      const bool slides = norm(slip) > 3.5 * sliding * g * dt;
      if (slides) {
        pull[i] = slip * (-sliding * g / norm(slip));
        spun[i] = pull[i] * -2.5;
      } else if (norm(p.velocity[i]) > rolling * g * dt) {
        pull[i] = p.velocity[i] * (-rolling * g / norm(p.velocity[i]));
      }
      light[i] = slides ? 1 : 5.0 / 7;
    }
    const Vec2d apart = p.at[1] - p.at[0], n = apart / norm(apart), across = perpendicular(n);
    if (norm(apart) <= 2 * radius + 1e-9) {
      const double round = dot(across, p.velocity[1] - p.velocity[0]);
      const double parts = dot(n, pull[1] - pull[0]) + round * round / (2 * radius);
      const double approach = -dot(n, p.velocity[1] - p.velocity[0]);
      const double force = (std::max(0.0, -parts) + std::max(0.0, approach / dt)) / (light[0] + light[1]);
      pull[0] -= n * (force * light[0]);
      pull[1] += n * (force * light[1]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      p.velocity[i] += pull[i] * dt;
      p.rolls[i] = light[i] < 1 ? p.velocity[i] : p.rolls[i] + spun[i] * dt;
      p.at[i] += p.velocity[i] * dt;
    }
  }
}

}  // namespace

TEST_CASE("two balls that press on each other move as the equations say") {
  constexpr std::uint64_t seed = 71;
  constexpr double seconds = 0.1;
  const Body ball{};
  const Boundary boundary(rectangle_table(20, 10), ball);
  Random r(seed);
  double worst = 0;
  int arcs = 0, compared = 0;
  for (int i = 0; i < 100; ++i) {
    TwoBalls p = random_pair(r, ball.radius);
    const std::array starts{BallStart<double>{&boundary, state_of(p, 0, ball.radius)},
                            BallStart<double>{&boundary, state_of(p, 1, ball.radius)}};
    ManyBalls sim(std::span<const BallStart<double>>(starts), SlideRoll{}, Han2005{}, BallBall{});
    bool met = false;
    while (sim.time() < seconds)
      met |= sim.step(seconds - sim.time(), [&](auto&&...) { ++arcs; }).event.kind == EventKind::ball;
    if (met) continue;  // a collision with restitution, which these equations lack
    ++compared;
    follow(p, ball.radius, seconds);
    INFO("number " << i << " of seed " << seed);
    for (int k = 0; k < 2; ++k) {
      const double off = norm(sim.state_now(k).at - p.at[static_cast<std::size_t>(k)]);
      CHECK(off < 1e-5);
      worst = std::max(worst, off);
    }
  }
  std::printf("%d pairs, at most %.1g m off, %.1f arcs each\n", compared, worst, arcs / 100.0);
  CHECK(compared > 80);
  CHECK(arcs < 100 * 20);  // pieces that are too short exceed this
}

TEST_CASE("the forces on two contacts settle in a few sweeps, those on many in some more") {
  constexpr std::uint64_t seed = 72;
  Random r(seed);
  for (int i = 0; i < 1000; ++i) {
    // A row, bent at random, in which each ball is driven along the row.
    const int balls = i % 2 ? 3 : r.integer(4, 8);
    std::vector<detail::Pressed<double>> contacts;
    std::vector<Vec2d> rates(1, {r.uniform(0, 1), 0});
    std::vector<double> masses(1, r.uniform(0.1, 0.2));
    for (int b = 1; b < balls; ++b) {
      contacts.push_back({b - 1, b, direction(r.uniform(-0.5, 0.5))});
      rates.push_back({r.uniform(-1, rates.back().x), 0});
      masses.push_back(r.uniform(0.1, 0.2));
    }
    const std::vector<Vec2d> own = rates;
    const auto settled = detail::Forces<double>(contacts, rates, masses).settle(balls == 3 ? 8 : 400);
    INFO("number " << i << " of seed " << seed << ", " << balls << " balls");
    REQUIRE(settled.settled);
    std::vector<Vec2d> forced = own;
    for (const detail::Pressed<double>& c : contacts) {
      const auto first = static_cast<std::size_t>(c.first), second = static_cast<std::size_t>(c.second);
      REQUIRE(c.force >= 0);
      forced[first] -= c.normal * (c.force / masses[first]);
      forced[second] += c.normal * (c.force / masses[second]);
    }
    for (const detail::Pressed<double>& c : contacts) {
      const double parts = detail::parting_rate<double>(c, forced);
      REQUIRE(parts > -1e-13);
      if (c.force > 0) REQUIRE(parts < 1e-13);
    }
  }
}

TEST_CASE("a ball that another pushes off the cushion which held it is at that cushion no longer") {
  const Body ball{};
  const Boundary boundary(rectangle_table(2, 1), ball);
  // The spin drives the ball into the bottom cushion.
  const State<double> start{{1, ball.radius}, {0.1, 0}, {1 / ball.radius, 0.1 / ball.radius, 0}};
  for (const double off : {-0.1, 0.0, 0.1}) {
    BallTrack<double> track(boundary, start);
    track.settle();
    track.begin(SlideRoll{});
    REQUIRE(track.on(0));
    track.press({0.3, off}, 2e-3);
    track.go(SlideRoll{}, 1e-3);
    CHECK(static_cast<bool>(track.on(0)) == (off <= 0));
  }
}
