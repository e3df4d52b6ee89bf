// SPDX-License-Identifier: MIT
//
// Compares the simulator's error (property 6) and its derivatives with 50 digits, on random shots of every family.
// Prints the worst ratio; `shots --truth N` does the same for any number of shots.
#include <cstdio>

#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"
#include "support/random_shot.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("the error of a run in double is within C 2^-53 size kappa", "[heavy]") {
  Worst worst("random shots", 10);  // a few ties in the family `corners` are normal
  constexpr std::uint64_t seed = 31;
  for (const ShotFamily family : shot_families) {
    Random random(seed);
    const int shots = family == ShotFamily::mathavan ? 10 : 40;  // an impact takes milliseconds in 50 digits
    for (int i = 0; i < shots; ++i) {
      const ShotRequest shot = random_shot(random, family);
      const Compared c = against_truth(shot, 8);
      INFO(name(family) << " number " << i << " of seed " << seed << ": " << write_shot(shot));
      if (c.kappa <= 1e6) CHECK(worst.within_bound(c));
    }
  }
  CHECK(worst.cases > 420);   // κ above 1e6 is rare
  CHECK(worst.ratio > 0.01);  // the bound is not too wide to be useful
}

TEST_CASE("derivatives through every event agree with differences in 50 digits", "[heavy]") {
  constexpr std::uint64_t seed = 37;
  double worst = 0;
  int compared = 0;
  for (const ShotFamily family : shot_families) {
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const ShotRequest shot = random_shot(random, family);
      const Boundary boundary(shot.table, shot.ball.body);
      const Run run{boundary, shot.physics, start_state(shot), 6};
      const Compared c = compare_with_truth(run);
      if (c.order != Compared::Order::same || c.kappa > 1e5) continue;
      bool at_cushion = false;  // derivatives are one-sided there
      for (const Wall& w : boundary.walls) at_cushion = at_cushion || dot(w.normal, run.start.at) - w.offset < 1e-9;
      if (at_cushion) continue;
      // The direction of a slip near 0 has few correct digits, and the derivatives change within that error.
      const Vec2d slip{run.start.velocity.x - boundary.body.radius * run.start.spin.y,
                       run.start.velocity.y + boundary.body.radius * run.start.spin.x};
      if (const double part = norm(slip) / norm(run.start.velocity); part > 2e-16 && part < 1e-5) continue;
      const Condition dual = condition(run);
      const truth::Jacobian exact = truth_jacobian(run);
      const double V = norm(run.start.velocity), R = boundary.body.radius, unit[] = {1, 1, V, V, V / R, V / R, V / R};
      INFO(name(family) << " number " << i << " of seed " << seed << ", kappa " << c.kappa << ": " << write_shot(shot));
      for (int out = 0; out < 2; ++out)
        for (int in = 0; in < (R > 0 ? 7 : 4); ++in) {
          const double off =
              std::abs(dual.jacobian[out][in] - exact.d[out][in]) * unit[in] / (boundary.extent * c.kappa);
          worst = std::max(worst, off);
          CHECK(off <= 1e-9);
        }
      ++compared;
    }
  }
  std::printf("derivatives: %d shots, worst difference %.2g of size kappa\n", compared, worst);
  CHECK(compared > 150);
}

TEST_CASE("two dual numbers give the columns that seven give") {
  using Dual = bankshot::Dual<2>;
  const ShotRequest shot = spin_shot({0.5, 0.3}, 4, 40, {.top = 0.3, .side = 0.8});
  const Boundary boundary(shot.table, shot.ball.body);
  const State<double> s = start_state(shot);
  const Condition c = condition({boundary, shot.physics, s, 3});
  State<Dual> dual{
      to<Dual>(s.at), {Dual(s.velocity.x, 0), Dual(s.velocity.y, 1)}, {Dual(s.spin.x), Dual(s.spin.y), Dual(s.spin.z)}};
  Simulator sim(boundary, std::get<SlideRoll>(shot.physics.motion), std::get<Han2005>(shot.physics.cushion), dual);
  for (int cushions = 0; cushions < 3;) cushions += sim.step().kind == EventKind::cushion;
  for (int k = 0; k < 2; ++k) {
    CHECK(sim.state().at.x.v[k] == Approx(c.jacobian[0][2 + k]).epsilon(1e-12));
    CHECK(sim.state().at.y.v[k] == Approx(c.jacobian[1][2 + k]).epsilon(1e-12));
  }
}
