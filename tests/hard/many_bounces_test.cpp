// SPDX-License-Identifier: MIT
//
// Many bounces, 20 … 20000.
// Why hard: Each bounce rounds anew and the path multiplies earlier errors. In a rectangle with mirrors the path
// unfolds to a straight line. After n bounces an error δ of the aim has grown to δ times the length, so κ, a sum over
// the bounces, grows as n².
// Achievable: n 2⁻⁵³ of the length when errors add up, √n 2⁻⁵³ when they do not.
// Asserted: The bound, and by hand the unfolded place in 50 digits. With spin and loss the path contracts, and 200
// bounces cost no digits.
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("20 to 20000 bounces between mirrors keep the bound") {
  Worst worst("many bounces");
  for (const HardCase& hard : hard_cases("many bounces")) {
    const Compared c = compare_with_truth(hard);
    INFO(hard.what << ": error " << c.error << " m, " << c.ratio() << " units, kappa " << c.kappa);
    CHECK(c.events == static_cast<std::size_t>(hard.cushions));
    CHECK(worst.within_bound(c));
    CHECK(c.error <= 2e-15 * hard.cushions * std::sqrt(hard.cushions));
  }
}

TEST_CASE("the unfolded path of a point, by hand") {
  // With speed (3, 4)/5 in a 1 × 1 square from (0.5, 0.5), the point has moved (3k, 4k) after t = 5k; it is back at the
  // start for even k.
  const Boundary boundary(rectangle_table(1, 1), {0});
  Simulator sim(boundary, Ideal{}, Mirror{1}, State<double>{{0.5, 0.5}, {0.6, 0.8}});
  int bounces = 0;
  while (sim.time() < 1000) bounces += sim.step(1000 - sim.time()).kind == EventKind::cushion;
  CHECK(bounces == 600 + 800);
  CHECK(norm(sim.state().at - Vec2d{0.5, 0.5}) < 1e-12);
}

TEST_CASE("with spin and hardly any loss hundreds of bounces stay true") {
  Worst worst("many bounces with spin");
  for (const HardCase& c : hard_cases("many bounces with spin")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}
