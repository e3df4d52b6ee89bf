// SPDX-License-Identifier: MIT
#include "planners/verify/in_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using planning::in_sight;

namespace {

constexpr double reach = 0.05715;

/// Returns how far a centre goes from the origin until it touches.
double way_to(const Circle& ball, const Vec2d& heading) {
  const double along = dot(ball.centre, heading), beside = cross(heading, ball.centre);
  const double left = ball.radius * ball.radius - beside * beside;
  return along > 0 && left > 0 ? along - std::sqrt(left) : std::numeric_limits<double>::infinity();
}

/// Returns the share of paths at a ball that touch it first.
double seen_by_rays(const Circle& ball, const std::vector<Circle>& others) {
  constexpr int rays = 4000;
  const double half = std::asin(ball.radius / norm(ball.centre)), middle = std::atan2(ball.centre.y, ball.centre.x);
  int seen = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec2d heading = direction(middle + half * (2 * (i + 0.5) / rays - 1));
    const double way = way_to(ball, heading);
    seen += std::ranges::none_of(others, [&](const Circle& other) { return way_to(other, heading) < way; });
  }
  return static_cast<double>(seen) / rays;
}

}  // namespace

TEST_CASE("a ball is in sight if some ray reaches it first") {
  constexpr std::uint64_t seed = 20261127;
  INFO("seed " << seed);
  Random random(seed);
  int hidden = 0, narrow = 0;
  for (int i = 0; i < 400; ++i) {
    const Circle ball{direction(random.uniform(0, radians(360.0))) * random.uniform(0.1, 1.5), reach};
    std::vector<Circle> others;
    for (int k = 0; k < 6; ++k) {
      // Around the way to it, or beside it.
      const Vec2d near = ball.centre * random.uniform(0.1, 1.1);
      const Vec2d at = near + Vec2d{random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5)} * reach;
      if (norm(at) > reach && norm(at - ball.centre) >= reach) others.push_back({at, reach});
    }
    const bool sees = in_sight({}, ball, others);
    const double share = seen_by_rays(ball, others);
    CAPTURE(i, share);
    if (!sees) CHECK(share == 0);
    hidden += !sees;
    narrow += sees && share == 0;
  }
  CHECK(hidden > 50);
  CHECK(hidden < 350);
  CHECK(narrow <= 8);  // between two of the rays
}

TEST_CASE("a ball that touches the cue ball hides what is behind it, and nothing beside it") {
  const Circle touching{{reach, 0}, reach};
  CHECK_FALSE(in_sight({}, {{1, 0}, reach}, std::vector{touching}));
  CHECK(in_sight({}, {{0, 1}, reach}, std::vector{touching}));
  CHECK(in_sight({}, touching, std::vector{Circle{{1, 0}, reach}}));
  CHECK(in_sight({}, {{1, 0}, reach}, {}));
}
