// SPDX-License-Identifier: MIT
//
// 05: find every shot to a point by exactly three cushions, with spin and real cushions. One new idea: --all.
#include <fmt/format.h>

#include <fstream>

#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  const Scene scene = preset_scene("carom-10ft");
  const Puzzle puzzle{.table = scene.table,
                      .physics = scene.physics,
                      .ball = {.at = {0.7, 0.5}, .body = scene.ball.body},
                      .spin = {.top = 0.5, .side = 0.5},
                      .target = PointTarget{.at = {2.1, 0.9}, .within = 0.03},
                      .cushions = CushionRule::exactly(3),
                      .prefer = Prefer::soft};
  const Answer answer = solve(puzzle, {.all = true});
  for (const Shot& shot : answer.shots) {
    fmt::print("{:8.3f} degrees  {:.3f} m/s  success {:.2f} ", degrees(shot.launch.angle), shot.launch.speed,
               *shot.robustness.success);
    for (const Contact cushion : shot.path.cushions) fmt::print(" {}", contact_name(puzzle.table, cushion));
    fmt::print("\n");
  }
  if (argc > 1) std::ofstream(argv[1]) << draw(puzzle, answer);
}
