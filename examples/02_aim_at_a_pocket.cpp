// SPDX-License-Identifier: MIT
//
// 02: find the aim and the speed that drop a ball straight into a pocket.
// One new idea: `solve` takes a Puzzle and returns an Answer with verified shots.
#include <fmt/format.h>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"

int main() {
  using namespace bankshot;
  const Scene scene = preset_scene("pool-9ft", "rolling");
  const Puzzle puzzle{.table = scene.table,
                      .physics = scene.physics,
                      .ball = {.at = {1.9, 0.5}, .body = scene.ball.body},
                      .target = PocketTarget{5},  // top-right
                      .cushions = CushionRule::exactly(0),
                      .arrive = Range{1, 1}};
  const Answer answer = solve(puzzle);
  const Shot& shot = answer.shots.at(0);
  fmt::print("{}: aim {:.4f} degrees at {:.4f} m/s\n", name(answer.status), degrees(shot.launch.angle),
             shot.launch.speed);
  fmt::print("drops after {:.4f} s at {:.4f} m/s, the line of travel {} the pocket's centre\n", shot.path.arrival.time,
             shot.path.arrival.speed, shot.verification.miss < 1e-9 ? "through" : "beside");
  fmt::print("made while the aim is off by {:+.3f} to {:+.3f} degrees\n", degrees(*shot.robustness.margin->angle[0]),
             degrees(*shot.robustness.margin->angle[1]));
}
