// SPDX-License-Identifier: MIT
#include "bankshot/contact/mirror.hpp"

#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

TEST_CASE("the normal velocity is reversed times the restitution, the tangential one kept") {
  State<double> s{{0, 0}, {3, -2}};
  Mirror{0.5}.bounce(Body{}, s, Vec2d{0, 1});
  CHECK(s.velocity == Vec2d{3, 1});
}

TEST_CASE("restitution 1 keeps the speed and 0 leaves no normal velocity") {
  test::Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.uniform(0, 6.28), b = random.uniform(0, 6.28);
    const Vec2d n{std::cos(a), std::sin(a)}, v{2 * std::cos(b), 2 * std::sin(b)};
    State<double> elastic{{0, 0}, v}, dead = elastic;
    Mirror{1}.bounce(Body{}, elastic, n);
    Mirror{0}.bounce(Body{}, dead, n);
    CHECK(norm(elastic.velocity) == Approx(2).epsilon(1e-14));
    CHECK(std::abs(dot(dead.velocity, n)) < 1e-15);
    CHECK(cross(n, dead.velocity) == Approx(cross(n, v)).margin(1e-15));
  }
}
