// SPDX-License-Identifier: MIT
//
// Points on tables with point pockets, counted by number theory: the laser in a triangle of mirrors (Project Euler,
// problem 202), and the shortest path with a given number of cushions (Code Golf 66817). All paths start in a vertex;
// no leg has length zero, and none leaves the table.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

/// Counts the ways from a vertex back to it with n bounces, past the other two: to the lattice point (a, b), a + b = (n
/// + 3) / 2.
std::size_t ways_in_triangle(int n) {
  std::size_t ways = 0;
  if (n % 2 == 0) return 0;
  const int sum = (n + 3) / 2;
  for (int a = 1; a < sum; ++a)
    if ((sum - 2 * a) % 3 == 0 && std::gcd(a, sum - a) == 1) ++ways;
  return ways;
}

Puzzle in_triangle(int n) {
  Puzzle p{.table = polygon_table({{0, 0}, {1, 0}, {0.5, std::sqrt(3) / 2}}), .physics = ideal_physics()};
  p.table.pockets = {{"C", p.table.vertices[0], 0}, {"B", p.table.vertices[1], 0}, {"A", p.table.vertices[2], 0}};
  p.ball.at = {0, 0};
  p.ball.body.radius = 0;
  p.target = PocketTarget{0};
  p.cushions = CushionRule::exactly(n);
  p.speed = {1, 1};
  return p;
}

/// Returns a puzzle with six pockets, the ball in the one at the lower left.
Puzzle on_rectangle(double length, double width, int n) {
  Puzzle p{.table = rectangle_table(length, width), .physics = ideal_physics()};
  for (const double x : {0.0, length / 2, length})
    for (const double y : {0.0, width})
      p.table.pockets.push_back({fmt::format("p{}", p.table.pockets.size()), {x, y}, 0});
  p.ball.at = {0, 0};
  p.ball.body.radius = 0;
  p.target = PocketTarget{};
  p.cushions = CushionRule::exactly(n);
  p.speed = {1, 1};
  p.prefer = Prefer::quick;
  return p;
}

/// Returns the length of the shortest path to a pocket (a, b) of the unfolded table that crosses n cushions, in half
/// lengths and whole widths.
double shortest(double length, double width, int n) {
  double least = 1e300;
  for (int b = 1; b <= n + 1; ++b)
    for (const int a : {2 * (n - b + 1) + 1, 2 * (n - b + 1) + 2})
      if (std::gcd(a, b) == 1) least = std::min(least, std::hypot(a * length / 2, b * width));
  return least;
}

}  // namespace

TEST_CASE("a laser that enters a triangle of mirrors at a vertex leaves there in as many ways as are counted") {
  std::size_t found = 0;
  int none = 0;
  for (int n = 1; n <= 23; ++n) {
    const Answer a = solve(in_triangle(n), {.all = true, .robustness = false});
    INFO(n << " bounces: " << a.message);
    const std::size_t ways = ways_in_triangle(n);
    CHECK(a.shots.size() == ways);
    CHECK(a.status == (ways > 0 ? Status::solved : Status::no_shot));
    found += a.shots.size();
    none += ways == 0;
  }
  CHECK(found == 15);
  CHECK(none == 17);
}

TEST_CASE("the shortest path from pocket to pocket is found among thousands of cushions, within the usual budget") {
  for (const auto& [length, width] : {std::pair{2.0, 1.0}, std::pair{4.76, 3.64}})
    for (const int n : {1, 4, 27, 1000, 10005}) {
      const Puzzle p = on_rectangle(length, width, n);
      const Answer a = solve(p, {.robustness = false});
      CAPTURE(length, width, n, a.message, a.simulations);
      REQUIRE(a.status == Status::solved);
      const Shot& shot = a.shots.front();
      CHECK(shot.path.cushions.size() == static_cast<std::size_t>(n));
      // The path ends where the pocket captures, within 1e-9 of the diagonal before its centre.
      CHECK(shot.path.arrival.time == Approx(shortest(length, width, n)).margin(1e-8));
      CHECK(shot.launch.angle < radians(90));
      CHECK(a.simulations < 20000);
    }
}
