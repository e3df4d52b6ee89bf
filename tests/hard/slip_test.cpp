// SPDX-License-Identifier: MIT
//
// Slip → 0.
// Why hard: The direction of a slip that is rounding noise is noise, and so is the decision whether there is a slide at
// all.
// Conditioning: Benign. The slide lasts 2u/(7 μs g) and changes the velocity by 2u/7, so a slip of δ v moves the place
// of rest by about 4/7 δ of the length of the path.
// Asserted: That shift, for δ = 1e-16 … 1e-3, and the bound.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

TEST_CASE("topspin near natural roll gives nearly the path of natural roll") {
  Worst worst("slip near 0");
  const auto rest = [](double top) {
    return simulate(spin_shot({0.3, 0.4}, 0.5, 10, {.top = top})).events.back().state.at;
  };
  const Vec2d rolling = rest(1);
  const double length = norm(rolling - Vec2d{0.3, 0.4});
  for (const double delta : {1e-16, 2e-16, 5e-16, 1e-15, 2e-15, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3})
    for (const double sign : {1.0, -1.0}) {
      const double top = 1 + sign * delta;
      INFO("topspin 1 + " << sign * delta);
      CHECK(norm(rest(top) - rolling) <= (delta * 4 / 7 * 1.1 + 2e-15) * length);
    }
  for (const HardCase& c : hard_cases("slip near 0")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("natural roll rolls from the start, at any angle and speed") {
  for (int degrees_ = 0; degrees_ < 360; ++degrees_)
    for (const double v : {1e-6, 0.1, 1.0, 30.0}) {
      const Trajectory t = simulate(spin_shot({1, 0.5}, v, degrees_, {.top = 1}));
      CHECK((t.events[1].kind == EventKind::cushion || t.events[1].kind == EventKind::rest));
    }
}
