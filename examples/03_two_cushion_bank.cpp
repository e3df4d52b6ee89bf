// SPDX-License-Identifier: MIT
//
// 03: list all shots of a two-cushion bank, the softest first, for a player to choose from. One new idea:
// options of `solve`.
#include <fmt/format.h>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/planner.hpp"

int main() {
  using namespace bankshot;
  const Puzzle puzzle{.table = make_table(*find_table_preset("carom-10ft")),
                      .physics = rolling_physics(),
                      .ball = {.at = {0.6, 0.5}, .body = {.radius = 0.03075, .mass = 0.21}},
                      .target = PointTarget{.at = {2.1, 1.0}, .within = 0.03},
                      .cushions = CushionRule::exactly(2),
                      .prefer = Prefer::soft};
  const Answer answer = solve(puzzle, {.all = true});
  for (const Shot& shot : answer.shots) {
    fmt::print("{:8.4f} degrees  {:.4f} m/s  success {:.2f} ", degrees(shot.launch.angle), shot.launch.speed,
               *shot.robustness.success);
    for (const Contact cushion : shot.path.cushions) fmt::print(" {}", contact_name(puzzle.table, cushion));
    fmt::print("\n");
  }
}
