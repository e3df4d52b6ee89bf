// SPDX-License-Identifier: MIT
//
// Rolling friction that grows with the speed, μr = a + b v.
// Why hard: The closed forms have b in their denominators and cancel as b → 0, and the place on the line is a root of
// Newton's method. With a large b the ball stops within centimetres.
// Conditioning: None of its own.
// Asserted: By hand, the length of a roll, (v − (a/b) ln(1 + b v/a))/(b g). The limit of constant friction. The bound
// for b from 1e-18 to 10 s/m.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

ShotRequest rolling(double v, RollingFriction friction) {
  ShotRequest shot = spin_shot({0.1, 0.5}, v, 0, {.top = 1});
  std::get<SlideRoll>(shot.physics.motion).rolling_friction = friction;
  return shot;
}

}  // namespace

TEST_CASE("a ball slowed by friction that grows with the speed rests where the formula says") {
  const double a = 0.02, g = 9.81, v = 0.5;
  for (const double b : {0.01, 0.1, 1.0, 10.0}) {
    const Trajectory t = simulate(rolling(v, {a, b}));
    INFO(b);
    CHECK(t.cushions == 0);
    CHECK(t.events.back().state.at.x - 0.1 == Approx((v - a / b * std::log1p(b * v / a)) / (b * g)).epsilon(1e-13));
    CHECK(t.events.back().time == Approx(std::log1p(b * v / a) / (b * g)).epsilon(1e-14));
  }
  const Vec2d constant = simulate(rolling(v, a)).events.back().state.at;
  for (const double b : {1e-18, 1e-12, 1e-8}) {
    // To first order the length v²/(2 a g) shrinks by the fraction 2 b v/(3 a).
    const double length = v * v / (2 * a * g);
    CHECK(norm(simulate(rolling(v, {a, b})).events.back().state.at - constant) <= length * b * v / a + 1e-15);
  }
}

TEST_CASE("with friction that grows with the speed the bound holds") {
  Worst worst("friction by speed");
  for (const HardCase& c : hard_cases("friction by speed")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}
