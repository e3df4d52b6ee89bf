// SPDX-License-Identifier: MIT
//
// 09: seven balls are on the table. Find every pot of any ball into any pocket, straight or by up to two cushions, the
// highest success first. With a file name, it draws the best shot.
#include <fmt/format.h>

#include <fstream>

#include "bankshot/bankshot.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  const Scene scene = preset_scene("pool-9ft");
  Puzzle puzzle{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  puzzle.ball.at = {0.635, 0.4};
  const Vec2d places[] = {{1.6, 0.7}, {2.0, 0.3}, {0.4, 1.0}, {1.2, 1.1}, {2.3, 1.0}, {1.0, 0.2}, {1.8, 1.0}};
  ObjectBallTarget target;
  for (const Vec2d& at : places) {
    target.balls.push_back(static_cast<int>(target.balls.size()) + 1);
    puzzle.others.push_back({at, scene.ball.body, std::to_string(target.balls.back())});
  }
  target.then = {PocketTarget{}, CushionRule{0, 2, {}}};
  puzzle.target = target;
  puzzle.cushions = CushionRule::exactly(0);

  const Answer answer = solve(puzzle, {.all = true});
  fmt::print("{}\n", answer.message);
  for (std::size_t i = 0; i < std::min<std::size_t>(answer.shots.size(), 8); ++i) {
    const Shot& shot = answer.shots[i];
    std::string by;
    for (const Contact cushion : shot.path.then.front().cushions)
      by += (by.empty() ? " by " : ", ") + contact_name(puzzle.table, cushion);
    fmt::print("{:3.0f} %  ball {} into {}{}: {:.1f} degrees, {:.1f} m/s, cut {:.0f} degrees{}\n",
               100 * *shot.robustness.success, puzzle.others[static_cast<std::size_t>(shot.arriving()) - 1].id,
               pocket_reached(puzzle, shot)->name, by, degrees(shot.launch.angle), shot.launch.speed,
               degrees(shot.path.hits.front().cut), shot.path.scratch ? ", and the cue ball falls, too" : "");
  }
  Answer best = answer;
  best.shots.resize(1);
  if (argc > 1) std::ofstream(argv[1]) << draw(puzzle, best);
}
