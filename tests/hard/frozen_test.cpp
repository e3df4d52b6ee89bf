// SPDX-License-Identifier: MIT
//
// Frozen to a cushion at the start.
// Why hard: A gap of 1e-16 … 1e-9 m is above or below what the centre's coordinates resolve, and a ball shot along the
// cushion must not bounce on noise.
// Law: A centre within Boundary::touch (1e-12 of the diagonal) is on the line. While a cushion holds a ball, its slip
// turns (detail/held.hpp).
// Conditioning: Benign, except for aims nearly along the cushion (grazing).
// Asserted: A ball driven in bounces at once, and a ball sent along or away does not. The bound holds for all gaps,
// spins and aims.
#include "support/against_truth.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr double R = 0.028575;
constexpr double gaps[] = {0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 2e-12, 1e-11, 1e-10, 1e-9};

}  // namespace

TEST_CASE("frozen balls stay within the bound whatever the gap, the aim and the spin") {
  Worst worst("frozen");
  for (const HardCase& c : hard_cases("frozen to a cushion")) {
    INFO(c.what);
    CHECK(worst.within_bound(compare_with_truth(c)));
  }
}

TEST_CASE("a frozen ball bounces at once when driven in, and not when sent along or away") {
  for (const double gap : gaps) {
    const Trajectory in = simulate(spin_shot({0.7, R + gap}, 1.5, 300));
    REQUIRE(in.cushions > 0);
    CHECK(in.events[1].kind == EventKind::cushion);
    CHECK(in.events[1].time <= gap / (1.5 * 0.86) * (1 + 1e-12));
    const Trajectory along = simulate(spin_shot({0.2, R + gap}, 1, 0, {.top = 1}));
    REQUIRE(along.cushions > 0);
    CHECK(along.sequence().front() == Contact::rail(1));
    const Trajectory away = simulate(spin_shot({0.7, R + gap}, 0.5, 90));
    CHECK(away.sequence() == std::vector<Contact>{});
  }
}

TEST_CASE("a ball frozen to a cushion and driven along it by masse stays on it and does not bounce") {
  // The ball is sent along the bottom cushion with spin about its line of travel. Friction presses it to the cushion
  // until it rolls (the spin curves right, aim 0), so by the law of resting it stays on the cushion.
  const Trajectory t = simulate(spin_shot({0.7, R}, 0.4, 0, {.masse = 2}));
  REQUIRE(t.events.size() > 2);
  CHECK(t.events[1].kind == EventKind::slide_to_roll);
  CHECK(t.events[1].state.at.y == R);
  CHECK(t.events[1].state.velocity.y == 0);
  CHECK(t.cushions == 0);
  // With the opposite spin it leaves the cushion.
  CHECK(simulate(spin_shot({0.7, R}, 0.4, 0, {.masse = -2})).events[1].state.at.y > R + 1e-3);
}

TEST_CASE("the slip of a ball on a cushion turns across it, as its equations say") {
  // u_t' = -7/2 c û_t and u_n' = -5/2 c û_n with c = μs g, so u_t = k u_n^(7/5) and v - 2/7 u_t is constant. The slide
  // takes 2/(5c) ∫ sqrt(1 + (u_t/u_n)²) du_n, and the ball loses the speed c ∫ û_t dt = 2/5 ∫ u_t/u_n du_n.
  constexpr double c = 0.2 * 9.81, v = 0.4;
  for (const double masse : {0.5, 1.0, 2.0, 5.0})
    for (const double top : {-1.0, 0.0, 0.5}) {
      INFO("masse " << masse << ", topspin " << top);
      const Trajectory t = simulate(spin_shot({0.2, R}, v, 0, {.top = top, .masse = masse}));
      REQUIRE(t.events[1].kind == EventKind::slide_to_roll);
      const double across = masse * v, along = (1 - top) * v;
      double seconds = 0, metres = 0, speed = v;
      constexpr int steps = 100000;
      for (int i = 0; i < steps; ++i) {
        const double u = across * (steps - i - 0.5) / steps, ratio = along / across * std::pow(u / across, 0.4),
                     dt = across / steps * std::sqrt(1 + ratio * ratio) / (2.5 * c);
        const double lost = across / steps * ratio / 2.5;
        metres += (speed - lost / 2) * dt;
        speed -= lost;
        seconds += dt;
      }
      CHECK(speed == Approx(v - along * 2 / 7).epsilon(1e-6));
      CHECK(t.events[1].state.velocity.x == Approx(v - along * 2 / 7).epsilon(1e-5));
      CHECK(t.events[1].time == Approx(seconds).epsilon(3e-4));
      CHECK(t.events[1].state.at.x - 0.2 == Approx(metres).epsilon(3e-4));
      CHECK(t.length > metres);  // it rolls on
      CHECK(std::isfinite(t.length));
    }
}

TEST_CASE("a ball that leaves a corner along either cushion is held by it until it rolls") {
  for (const auto& [aim, masse] :
       {std::pair{0.0, 1.0}, std::pair{0.0, 0.2}, std::pair{90.0, -1.0}, std::pair{90.0, -0.2}}) {
    INFO("aim " << aim << ", masse " << masse);
    const ShotRequest shot = spin_shot({R, R}, 1, aim, {.masse = masse});
    const Boundary boundary(shot.table, shot.ball.body);
    const Trajectory t = simulate(shot);
    CHECK(t.legs.size() > 20);  // pieces of 2 ms
    for (const Leg& leg : t.legs) CHECK(boundary.clearance(leg.arc.position(leg.duration)) >= -boundary.touch);
  }
}
