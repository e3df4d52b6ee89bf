// SPDX-License-Identifier: MIT
//
// The limits of a launch, compared with closed forms and with sums over the plane of errors.
#include "planners/evaluate/limits.hpp"

#include <cmath>
#include <numbers>

#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::planning;

namespace {

using Number = Dual<2>;
const Launch launch{2, 0};
const Noise player{.angle = 0.01, .speed = 0.1};

/// Returns a number of this value, with slopes by one deviation of the player's aim and speed.
Number in_plane(double value, double by_aim, double by_speed) {
  Number out(value);
  out.v[0] = by_aim / 0.01;
  out.v[1] = by_speed / 0.05;  // a deviation is a twentieth of the speed
  return out;
}

double below(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

/// Returns the probability that a pair of normal errors does what `made` says.
template <class F>
double over_the_plane(const F& made) {
  constexpr double step = 0.02, far = 5;
  double sum = 0;
  for (double x = -far + step / 2; x < far; x += step)
    for (double y = -far + step / 2; y < far; y += step)
      if (made(Vec2d{x, y})) sum += std::exp(-(x * x + y * y) / 2) * step * step / (2 * std::numbers::pi);
  return sum;
}

/// Largest error of a sum over the 32 directions that are looked at.
constexpr double of_directions = 0.01;

}  // namespace

TEST_CASE("the success inside straight limits is that of the normal distribution") {
  const double room = GENERATE(0.1, 0.7, 2.0);
  CAPTURE(room);
  const Vec2d slope{0.6, 0.8};
  Limits one(launch, player);
  one.keep(in_plane(room, slope.x, slope.y));
  CHECK(norm(one.in_deviations(in_plane(room, slope.x, slope.y)) - slope) < 1e-15);
  CHECK(one.success(slope, 1) == Approx(below(room)).margin(of_directions));
  Limits strip = one;
  strip.add(room, -slope);
  CHECK(strip.success(slope, room) == Approx(std::erf(room / std::sqrt(2.0))).margin(of_directions));
  Limits thin(launch, player);
  for (const double side : {1.0, -1.0}) thin.add(0.01 * room, slope * side);
  CHECK(thin.success(slope, 0.01 * room) == Approx(std::erf(0.01 * room / std::sqrt(2.0))).epsilon(0.01));
  Limits quarter = one;
  quarter.add(0.5, {-0.8, 0.6});
  CHECK(quarter.success(slope, 1) == Approx(below(room) * below(0.5)).margin(of_directions));
  CHECK(Limits(launch, player).success({1, 0}, 1) == Approx(1));
}

TEST_CASE("the success of a rest is the probability that errors leave it on its disc") {
  Limits circle(launch, player);
  circle.rest({in_plane(0, 0.3, 0), in_plane(0, 0, 0.3)}, 0.4);
  CHECK(circle.success() == Approx(1 - std::exp(-0.5 * (0.4 * 0.4) / (0.3 * 0.3))).margin(1e-3));
  constexpr std::uint64_t seed = 8;
  Random random(seed);
  for (int i = 0; i < 6; ++i) {
    INFO("ellipse " << i << " of seed " << seed);
    const Vec2d from{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)}, by_aim{random.uniform(-1, 1), 0.5},
        by_speed{random.uniform(-1, 1), random.uniform(-0.4, 0.4)};
    Limits limits(launch, player);
    limits.rest({in_plane(from.x, by_aim.x, by_speed.x), in_plane(from.y, by_aim.y, by_speed.y)}, 0.5);
    CHECK(limits.success() == Approx(over_the_plane([&](const Vec2d& z) {
                                return norm(from + by_aim * z.x + by_speed * z.y) < 0.5;
                              })).margin(of_directions));
  }
}

TEST_CASE("a direction is free until the first limit breaks, and broken limits until the last holds again") {
  constexpr std::uint64_t seed = 9;
  Random random(seed);
  int inside = 0, outside = 0;
  for (int i = 0; i < 300; ++i) {
    INFO("limits " << i << " of seed " << seed);
    const Number a = in_plane(random.uniform(-0.3, 1), random.uniform(-1, 1), random.uniform(-1, 1)),
                 b = in_plane(random.uniform(-0.3, 1), random.uniform(-1, 1), random.uniform(-1, 1)),
                 x = in_plane(random.uniform(-0.4, 0.4), random.uniform(-1, 1), random.uniform(-1, 1)),
                 y = in_plane(random.uniform(-0.4, 0.4), random.uniform(-1, 1), random.uniform(-1, 1));
    Limits limits(launch, player);
    limits.keep(a);
    limits.keep(b);
    limits.rest({x, y}, 0.5);
    const Vec2d towards = direction(random.uniform(0, 6.28));
    const auto moved = [&](const Number& n, double t) { return n.a + dot(limits.in_deviations(n), towards) * t; };
    const auto hold = [&](double t) {
      return moved(a, t) > 0 && moved(b, t) > 0 && std::hypot(moved(x, t), moved(y, t)) < 0.5;
    };
    CHECK(limits.hold() == hold(0));
    if (hold(0)) {
      const double t = limits.until(towards);
      CHECK(hold(t * (1 - 1e-9)));
      CHECK(!hold(t * (1 + 1e-9)));
      CHECK(limits.until_all_hold(towards) == 0);
      ++inside;
    }
    // A direction may lead back to launches that hold all limits; the first of them is found.
    double first = 0;
    while (!hold(first) && first < 4) first += 1e-3;
    if (hold(0) || first >= 4) continue;
    CHECK(limits.until_all_hold(towards) == Approx(first).margin(1e-3));
    ++outside;
  }
  CHECK(inside > 50);
  CHECK(outside > 20);
}
