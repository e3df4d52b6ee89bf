// SPDX-License-Identifier: MIT
//
// 06: compare the safest shot with the centred one. The ball should rest within 10 cm of a point near a corner
// pocket; a little too hard, and it drops. A ball that stops short misses the exact point, but its success is
// higher. One new idea: aim.
#include <fmt/format.h>

#include <fstream>

#include "bankshot/draw/svg.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  const Scene scene = preset_scene("pool-9ft");
  Puzzle puzzle{.table = scene.table,
                .physics = scene.physics,
                .ball = {.at = {0.8, 0.9}, .body = scene.ball.body},
                .target = PointTarget{.at = {2.47, 0.07}, .within = 0.1},
                .cushions = CushionRule::exactly(0),
                .noise = {.angle = radians(0.125), .speed = 0.02}};
  std::vector<LabelledPath> paths;
  for (const Aim aim : {Aim::centre, Aim::safest}) {
    puzzle.aim = aim;
    const Answer answer = solve(puzzle);
    const Shot& shot = answer.shots.at(0);
    const char* name = aim == Aim::centre ? "centre" : "safest";
    fmt::print("{}: {:.3f} degrees, {:.3f} m/s, rests {:.0f} mm beside the point, success {:.2f}\n", name,
               degrees(shot.launch.angle), shot.launch.speed, 1e3 * shot.verification.miss, *shot.robustness.success);
    paths.push_back({name, simulate(as_request(puzzle, shot))});
  }
  if (argc > 1) std::ofstream(argv[1]) << draw(puzzle.table, puzzle.ball, paths);
}
