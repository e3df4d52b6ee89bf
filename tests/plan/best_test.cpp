// SPDX-License-Identifier: MIT
//
// Compares the softest and the quickest shot of `--all` with brute force that shares only the simulator with the
// planners (support/by_force.hpp), where nothing is left free; each must find what the other finds. Also compares plain
// `solve` with the first shot of `--all`. The longer runs are in stress/best.cpp.
#include <fmt/format.h>

#include <array>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/by_force.hpp"
#include "support/catch.hpp"
#include "support/forward.hpp"

using namespace bankshot;

namespace {

/// Returns what `prefer` minimizes.
double cost(Prefer prefer, double speed, double time) { return prefer == Prefer::soft ? speed : time; }

}  // namespace

TEST_CASE("the best of all shots is that of brute force") {
  constexpr int puzzles = 12;
  constexpr std::uint64_t seed = 3;
  constexpr double little = 0.005;  // a relative difference up to this counts as equal
  int compared = 0;
  for (int i = 0; i < puzzles; ++i) {
    test::Random random(seed, static_cast<std::uint64_t>(i));
    Puzzle p = test::ask_for_some(random, -1, 3, [&] {
                 return std::optional(test::usual_shot(random, test::Model::spin));
               }).puzzle;
    p.prefer = i % 2 ? Prefer::quick : Prefer::soft;
    p.cushions = {0, 3, {}};
    const Answer all = solve(p, {.all = true, .robustness = false});
    const auto forced = test::best_by_force(p, {.grid = {.aim = radians(0.1)}}).best;
    INFO("puzzle " << i << " of seed " << seed);
    REQUIRE(all.status == Status::solved);
    if (all.shots.front().verification.off_centre) {
      CHECK(!forced);
      continue;
    }
    REQUIRE(forced);
    ++compared;
    const Shot& best = all.shots.front();
    const double by_solve = cost(p.prefer, best.launch.speed, best.path.arrival.time),
                 by_force = cost(p.prefer, forced->launch.speed, forced->time);
    CHECK(by_solve <= by_force * (1 + little));
    CHECK(by_force <= by_solve * (1 + little));
  }
  CHECK(compared > puzzles / 2);
}

TEST_CASE("plain solve is hardly ever worse than the first of all, in a few hundred simulations") {
  constexpr int puzzles = 50;
  constexpr std::uint64_t seed = 4;
  constexpr double little = 0.005;  // of speed, of time, or of success
  for (const Prefer prefer : {Prefer::robust, Prefer::soft, Prefer::quick}) {
    int compared = 0, worse = 0;
    long simulations = 0;
    for (int i = 0; i < puzzles; ++i) {
      test::Random random(seed, static_cast<std::uint64_t>(i));
      Puzzle p = test::ask_for_some(random, -1, 3, [&] {
                   return std::optional(test::usual_shot(random, test::Model::spin));
                 }).puzzle;
      p.prefer = prefer;
      p.cushions = {0, 3, {}};
      const bool robust = prefer == Prefer::robust;
      const Answer best = solve(p, {.robustness = robust}), all = solve(p, {.all = true, .robustness = robust});
      REQUIRE(best.status == Status::solved);
      REQUIRE(all.status == Status::solved);
      const Shot &a = best.shots.front(), &b = all.shots.front();
      if (a.verification.off_centre || b.verification.off_centre) continue;
      ++compared;
      simulations += best.simulations;
      const double by = robust ? *b.robustness.success - *a.robustness.success
                               : cost(prefer, a.launch.speed, a.path.arrival.time) /
                                         cost(prefer, b.launch.speed, b.path.arrival.time) -
                                     1;
      worse += by > little;
    }
    INFO("prefer " << static_cast<int>(prefer) << ": " << worse << " of " << compared << ", " << simulations
                   << " simulations, seed " << seed);
    CHECK(compared > puzzles * 2 / 3);
    CHECK(worse <= 1);
    CHECK(simulations < 800L * compared);
  }
}

TEST_CASE("a shot that may pass its point on the way is not passed over for what its last leg alone promises") {
  // Nearby aims pass the point one leg earlier; the shot's own aim does not.
  const char* const puzzle = R"({{"table": {{"length": 2.54, "width": 1.27, "pockets": "none"}}, "physics": "rolling",
      "ball": {{"at": [{}, {}]}}, "target": {{"point": [{}, {}]}}, "cushions": {{"max": 3}}, "arrive": {{"speed": {}}}}})";
  constexpr std::array<std::array<double, 5>, 3> cases{{{1.1325, 0.8980, 1.8462, 0.7437, 0.1042},
                                                        {0.9966, 1.0428, 2.0023, 0.5321, 0.1140},
                                                        {1.7624, 0.8372, 0.8981, 0.7989, 0.1166}}};
  for (const auto& [x, y, to_x, to_y, arrive] : cases) {
    const Puzzle p = read_puzzle(fmt::format(fmt::runtime(puzzle), x, y, to_x, to_y, arrive));
    const Answer best = solve(p), all = solve(p, {.all = true});
    INFO("from " << x << ", " << y);
    REQUIRE(best.status == Status::solved);
    REQUIRE(all.status == Status::solved);
    CHECK(*all.shots.front().robustness.success > *all.shots[1].robustness.success + 0.05);
    CHECK(*best.shots.front().robustness.success > *all.shots.front().robustness.success - 0.005);
  }
}
