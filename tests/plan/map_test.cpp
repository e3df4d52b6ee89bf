// SPDX-License-Identifier: MIT
//
// Checks by a map with finer cells that the forward map finds every shot. A longer run by hand: test_plan "[long]"
#include <algorithm>
#include <cstdio>

#include "bankshot/plan/planner.hpp"
#include "planners/propose/proposers.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

Puzzle three_or_more(test::Random& random, int cushions) {
  const double length = random.log_uniform(1, 4), width = length * random.uniform(0.4, 1);
  const auto place = [&] { return Vec2d{random.uniform(0.03, length - 0.03), random.uniform(0.03, width - 0.03)}; };
  Puzzle p{.table = rectangle_table(length, width), .physics = spin_physics()};
  p.ball.at = place();
  p.target = PointTarget{place()};
  p.spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
  p.cushions = CushionRule::exactly(cushions);
  p.budget = 100000000;
  return p;
}

std::vector<Shot> mapped(const Puzzle& p, const planning::Spacing& spacing) {
  const planning::SearchRequest request(p, planning::Wanted::all);
  planning::EvaluationBudget budget(budget_of(p));
  planning::SearchResult found;
  planning::propose::partition(request, budget, found, spacing);
  return found.shots;
}

void compare(int puzzles, int cushions, std::uint64_t seed, double most_missed) {
  constexpr planning::Spacing fine{radians(0.5), 0.03};
  test::Random random(seed);
  std::size_t found = 0, missed = 0;
  for (int i = 0; i < puzzles; ++i) {
    const Puzzle p = three_or_more(random, cushions);
    const std::vector<Shot> all = solve(p, {.planner = "sweep", .all = true, .robustness = false}).shots;
    for (const Shot& shot : mapped(p, fine)) {
      const auto same = [&](const Shot& x) {
        return x.path.cushions == shot.path.cushions && std::abs(x.launch.angle - shot.launch.angle) < 1e-6;
      };
      ++found;
      missed += std::none_of(all.begin(), all.end(), same);
    }
  }
  INFO(missed << " of " << found << " shots with " << cushions << " cushions missed, seed " << seed);
  std::printf("%d,%llu,%d,%zu,%zu\n", cushions, static_cast<unsigned long long>(seed), puzzles, found, missed);
  CHECK(found > static_cast<std::size_t>(puzzles));
  CHECK(static_cast<double>(missed) <= most_missed * static_cast<double>(found));
}

}  // namespace

TEST_CASE("the map of aim and speed finds every shot that a finer one finds") { compare(6, 3, 17, 0); }

// Prints the lines of tests/bench/results/all-shots.csv.
TEST_CASE("the map misses hardly a shot with three to five cushions", "[.][long]") {
  std::printf("cushions,seed,puzzles,shots,missed\n");
  compare(100, 3, test::seed_or_fresh(17), 0);
  for (const std::uint64_t seed : {5, 6, 7}) compare(200, 3, test::seed_or_fresh(seed), 0.001);
  for (const std::uint64_t seed : {17, 8, 108, 208}) compare(100, 4, test::seed_or_fresh(seed), 0.001);
  for (const std::uint64_t seed : {17, 8, 108, 208}) compare(100, 5, test::seed_or_fresh(seed), 0.001);
}

// These shots rest soon after their last bounce, or just before a fold. Nodes of the map meet their routes, but the
// search from those nodes does not reach the root.
TEST_CASE("all shots include those of sequences whose nodes lead nowhere") {
  struct Case {
    double length, width;
    Vec2d ball, target;
    LaunchSpin spin;
    int cushions;
    double angle;  // degrees
  };
  for (const Case& c : {Case{3.7004579052154587,
                             2.73895672384495,
                             {1.5521153935957388, 0.6344982811096583},
                             {3.58630600550486, 0.32141582491370957},
                             {-0.7949410053802956, 0.5431207901170816, 0},
                             3,
                             201.4456095},
                        Case{1.4646644716653876,
                             0.7120685166712877,
                             {0.08330293184657275, 0.5341971125600873},
                             {1.2187323900803084, 0.3422096076878597},
                             {-0.8477452172464544, -0.7597516024620448, 0},
                             4,
                             339.5381693},
                        Case{1.2382250337572553,
                             0.8881349433614231,
                             {0.9038645846691813, 0.33347373243955103},
                             {0.03037540483166975, 0.38538413906820235},
                             {0.6038399985402001, -0.9050956848847891, 0},
                             5,
                             343.4313254}}) {
    Puzzle p{.table = rectangle_table(c.length, c.width), .physics = spin_physics()};
    p.ball.at = c.ball;
    p.target = PointTarget{c.target};
    p.spin = c.spin;
    p.cushions = CushionRule::exactly(c.cushions);
    const std::vector<Shot> all = solve(p, {.all = true, .robustness = false}).shots;
    CAPTURE(c.length, c.angle, all.size());
    CHECK(std::any_of(all.begin(), all.end(),
                      [&](const Shot& s) { return std::abs(degrees(s.launch.angle) - c.angle) < 1e-5; }));
  }
}
