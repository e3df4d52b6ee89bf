// SPDX-License-Identifier: MIT
//
// If the planner says that a pocket has no shot at a launch speed, brute force over the aims must find none. Brute
// force shares only the simulator with the planners. A longer run by hand: test_plan "[long]"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/flight.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

Puzzle random_pocket(test::Random& r, bool jaws) {
  const TablePreset& preset = *find_table_preset(r.chance(0.5) ? "pool-9ft" : "snooker-12ft");
  Puzzle p{.table = make_table(preset, jaws), .physics = spin_physics(preset.body, preset.nose())};
  p.ball.body = preset.body;
  const double R = preset.body.radius;
  p.ball.at = {r.uniform(R, preset.length - R), r.uniform(R, preset.width - R)};
  if (r.chance(0.5)) p.spin = {r.uniform(-0.5, 1), r.uniform(-0.5, 0.5), 0};
  const double speed = r.log_uniform(0.5, 8);
  p.speed = {speed, speed};
  p.target = PocketTarget{r.integer(0, 5)};
  std::vector<Contact> route;
  for (int n = r.integer(0, 3); n > 0; --n) {
    int rail = r.integer(0, 3);
    while (!route.empty() && route.back().index == rail) rail = r.integer(0, 3);
    route.push_back(Contact::rail(rail));
  }
  p.cushions = r.chance(0.3) ? CushionRule::exactly(static_cast<int>(route.size())) : CushionRule::in_order(route);
  return p;
}

/// Counts the puzzles that have a shot although the answer says that there is none.
int missed_of(int count, bool jaws) {
  constexpr int aims = 18000;  // steps of 0.02 degrees
  const std::uint64_t seed = test::seed_or_fresh(21);
  int missed = 0;
  for (std::uint64_t i = 0; count > 0; ++i) {
    test::Random r(seed, i);
    const Puzzle p = random_pocket(r, jaws);
    const Answer a = solve(p, {.first = true, .suggest = false});
    if (a.status == Status::solved) continue;
    --count;
    const test::Aimed aimed(p);
    for (int k = 0; k < aims; ++k) {
      const double angle = radians(360.0 * k / aims);
      if (!test::makes(aimed, {p.speed.low, angle}, p.spin)) continue;
      ++missed;
      UNSCOPED_INFO("seed " << seed << ", puzzle " << i << " at " << degrees(angle) << " degrees: " << write_puzzle(p));
      break;
    }
  }
  return missed;
}

}  // namespace

TEST_CASE("a no-shot into a pocket has no shot: circles") { CHECK(missed_of(8, false) == 0); }
TEST_CASE("a no-shot into a pocket has no shot: jaws") { CHECK(missed_of(8, true) == 0); }
TEST_CASE("two hundred no-shots into pockets have no shot: circles", "[.][long]") { CHECK(missed_of(200, false) == 0); }
TEST_CASE("two hundred no-shots into pockets have no shot: jaws", "[.][long]") { CHECK(missed_of(200, true) == 0); }
