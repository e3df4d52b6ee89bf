// SPDX-License-Identifier: MIT
//
// Verification is the only way to a shot: whatever proposes a launch, each bound of the puzzle is checked. The safest
// shot and the nearest miss go the same way.
#include <atomic>

#include "bankshot/plan/planner.hpp"
#include "planners/verify/prove.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/straight.hpp"

using namespace bankshot;
using bankshot::test::straight;
using namespace bankshot::planning;

namespace {

Proof tried(const Puzzle& p, const Launch& launch, Demand demand = Demand::exact, long most = 100) {
  const SearchRequest request(p);
  EvaluationBudget budget(most);
  return prove(request, budget, launch, Goal::of(request, demand));
}

/// Returns the launch speed that passes the point, 1 m ahead, at 0.5 m/s.
double fitting() { return std::sqrt(0.25 + 2 * 0.01 * 9.81); }

}  // namespace

TEST_CASE("a proof holds every bound of the puzzle") {
  const Launch good{fitting(), 0};
  REQUIRE(tried(straight(), good).holds());
  Puzzle p = straight();
  p.angle = Range{radians(10), radians(20)};
  CHECK(tried(p, good).failure.reason == FailureReason::outside_aim);
  p = straight();
  p.speed = {1, 2};
  CHECK(tried(p, good).failure.reason == FailureReason::too_slow);
  CHECK(tried(p, good).failure.speed == good.speed);
  p.speed = {0.1, 0.5};
  CHECK(tried(p, good).failure.reason == FailureReason::too_fast);
  p = straight();
  p.cushions = CushionRule::exactly(1);
  CHECK_FALSE(tried(p, good).holds());
  p.cushions = CushionRule::in_order({Contact::rail(1)});
  CHECK_FALSE(tried(p, good).holds());
  CHECK(tried(straight(), good, Demand::exact, 0).failure.reason == FailureReason::no_budget);
  p = straight();
  p.table.pockets.push_back({"well", {1, 0.5}, 0.1});
  CHECK(tried(p, good).failure.reason == FailureReason::pocketed);
}

TEST_CASE("a proof tells an exact shot from one that is made, and from one at another speed") {
  const Launch beside{fitting(), 0.005}, faster{fitting() + 0.01, 0};
  CHECK(tried(straight(), beside).failure.reason == FailureReason::inexact);
  const Proof off = tried(straight(), beside, Demand::made);
  CHECK(off.holds());
  CHECK(off.shot.verification.off_centre);
  CHECK(off.shot.verification.miss == Approx(0.005).epsilon(0.01));
  CHECK(tried(straight(), faster).failure.reason == FailureReason::inexact);
  CHECK(tried(straight(), faster, Demand::off_centre).failure.reason == FailureReason::inexact);
  CHECK(tried(straight(), faster, Demand::made).holds());
}

TEST_CASE("a proof brings back what rounding carried out of a bound, and no more") {
  Puzzle p = straight();
  p.angle = Range{0, radians(20)};
  p.speed = {fitting(), 2};
  const Proof proof = tried(p, {fitting() * (1 - 1e-14), -1e-14});
  REQUIRE(proof.holds());
  CHECK(proof.shot.launch.speed == fitting());
  CHECK(proof.shot.launch.angle == 0);
  CHECK_FALSE(tried(p, {fitting() * (1 - 1e-9), 0}).holds());
}

TEST_CASE("the safest shot keeps the bounds of the aim, and the budget to one path") {
  test::Random random(31);
  int moved = 0;
  for (int i = 0; i < 120; ++i) {
    Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::rolling).puzzle;
    p.aim = Aim::safest;
    p.angle.reset();
    const Answer free = solve(p, {.robustness = false, .suggest = false});
    if (free.shots.empty()) continue;
    const double aim = free.shots[0].launch.angle;
    p.angle = Range{aim - 1e-4, aim + 1e-4};
    const Answer bound = solve(p, {.robustness = false, .suggest = false});
    for (const Shot& s : bound.shots) {
      CAPTURE(i, s.launch.angle, aim);
      CHECK(std::abs(s.launch.angle - aim) < 1.0001e-4);
      moved += s.verification.off_centre;
    }
    p.angle.reset();
    p.budget = 50;
    const long safest = solve(p, {.robustness = false, .suggest = false}).simulations;
    p.aim = Aim::centre;
    CHECK(safest <= std::max(51L, solve(p, {.robustness = false, .suggest = false}).simulations));
  }
  CHECK(moved >= 10);
}

TEST_CASE("a nearest miss shows what its launch does, with the spin that was asked") {
  Puzzle p = straight();
  p.physics = spin_physics();
  p.spin = {.top = 0.5, .side = 0.25};
  p.angle = Range{radians(90), radians(100)};
  const Answer a = solve(p, {.suggest = false});
  REQUIRE(a.status == Status::no_shot);
  REQUIRE(a.nearest);
  CHECK(a.nearest->shot.spin.side == 0.25);
  CHECK(a.nearest->why.find("outside the bounds") != std::string::npos);
  CHECK(a.nearest->shot.verification.miss == Approx(1));  // every aim inside the bounds leads away from the start
}

TEST_CASE("a cancelled search ends, and says so") {
  const std::atomic<bool> cancelled = true;
  const Answer a = solve(straight(), {.cancelled = &cancelled});
  CHECK(a.status == Status::budget);
  CHECK(a.simulations == 0);
  CHECK(a.message == "the search was cancelled before it found a shot");
}
