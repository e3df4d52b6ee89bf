// SPDX-License-Identifier: MIT
//
// 10: play on a table that leans by 2 mm per metre. It shows where the level table's shot ends, how the aim changes,
// and what small errors of coefficients cost. One new idea: Physics::tilt.
#include <fmt/format.h>

#include <fstream>

#include "bankshot/draw/svg.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"

using namespace bankshot;

namespace {

Trajectory to_rest(const Puzzle& puzzle, const Launch& launch) {
  return simulate({.table = puzzle.table, .physics = puzzle.physics, .ball = puzzle.ball, .launch = launch});
}

void tell(const char* name, const Shot& shot) {
  fmt::print("{}: aim {:.2f} degrees, {:.2f} m/s, success {:.2f}\n", name, degrees(shot.launch.angle),
             shot.launch.speed, *shot.robustness.success);
}

}  // namespace

int main(int argc, char** argv) {
  const Scene scene = preset_scene("carom-10ft");
  Puzzle level{
      .table = scene.table, .physics = scene.physics, .target = PointTarget{.at = {2.3, 0.35}, .within = 0.06}};
  level.ball = {.at = {0.6, 0.4}, .body = scene.ball.body};
  level.cushions = CushionRule::in_order({*find_cushion(scene.table, "top"), *find_cushion(scene.table, "right")});
  Puzzle leaning = level;
  leaning.physics.tilt = {0, 0.002};  // it rises towards the top rail
  const Shot before = solve(level).shots.at(0);
  const Answer answer = solve(leaning, {.sensitivity = true});
  const Shot& after = answer.shots.at(0);
  tell("level", before);
  tell("leaning", after);
  const Trajectory as_before = to_rest(leaning, before.launch);
  fmt::print("the level table's shot, played there, rests {:.0f} mm from the place\n",
             1000 * norm(as_before.events.back().state.at - Vec2d{2.3, 0.35}));
  for (const Sensitivity& s : after.robustness.sensitivity)
    if (s.coefficient.starts_with("tilt") || s.coefficient == "cushion.height")
      fmt::print("1 mm{} of {} moves it by {:.0f} mm\n", s.coefficient == "cushion.height" ? "" : " a metre",
                 s.coefficient, s.by);
  const LabelledPath paths[] = {{"on a level table", to_rest(level, before.launch)},
                                {"the same shot where it leans", as_before},
                                {"the shot for it", to_rest(leaning, after.launch)}};
  if (argc > 1) std::ofstream(argv[1]) << draw(leaning.table, leaning.ball, paths);
}
