// SPDX-License-Identifier: MIT
#include "bankshot/motion/rolling.hpp"

#include "bankshot/motion/ideal.hpp"
#include "support/catch.hpp"

using namespace bankshot;

TEST_CASE("rolling stops after v/(mu g) seconds and v^2/(2 mu g) metres") {
  for (const double v : {1e-6, 0.3, 2.0, 30.0}) {
    const Rolling rolling{.friction = 0.013, .g = 9.81};
    const Arc<double> arc = rolling.arc(Body{}, State<double>{{1, 2}, Vec2d{0.6, -0.8} * v});
    CHECK(arc.duration == Approx(v / (0.013 * 9.81)).epsilon(1e-14));
    CHECK(norm(arc.position(arc.duration) - arc.at) == Approx(v * v / (2 * 0.013 * 9.81)).epsilon(1e-13).margin(1e-15));
    CHECK(norm(arc.velocity_at(arc.duration)) < 1e-15 * v);
  }
}

TEST_CASE("the acceleration is against the velocity, so the path is straight") {
  const Arc<double> arc = Rolling{}.arc(Body{}, State<double>{{0, 0}, {1.7, 0.4}});
  CHECK(std::abs(cross(arc.velocity, arc.acceleration)) < 1e-17);
  CHECK(dot(arc.velocity, arc.acceleration) < 0);
}

TEST_CASE("without friction a rolling ball moves like an ideal one") {
  const State<double> s{{0.1, 0.2}, {1, 2}};
  const Arc<double> a = Rolling{.friction = 0}.arc(Body{}, s), b = Ideal{}.arc(Body{}, s);
  CHECK(a.acceleration == b.acceleration);
  CHECK(a.duration == forever);
  CHECK(b.duration == forever);
}

TEST_CASE("a ball that does not move is at rest at once") {
  CHECK(Rolling{}.arc(Body{}, State<double>{{0, 0}, {0, 0}}).duration == 0);
}
