// SPDX-License-Identifier: MIT
//
// 11: learn the unknown cloth and cushions of a table from thirty filmed shots. Then plan new bank shots with the
// learnt values and with the usual values of tables, and compare. One new idea: fit().
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <span>

#include "bankshot/draw/fit.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/camera.hpp"

using namespace bankshot;

namespace {

/// Returns true if the launch, with random errors of aim and speed, makes the shot on the true table.
bool is_made(const Puzzle& puzzle, const Physics& truth, Launch launch, Random& random) {
  const auto error = [&] { return random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1); };
  launch.angle = wrap_angle(launch.angle + puzzle.noise.angle * error());
  launch.speed += puzzle.noise.speed * error();
  const Trajectory t =
      simulate({.table = puzzle.table, .physics = truth, .ball = puzzle.ball, .launch = launch, .spin = puzzle.spin});
  const auto fell = std::ranges::find(t.events, EventKind::pocket, &Record::kind);
  return fell != t.events.end() && t.cushions == puzzle.cushions.min &&
         fell->contact.index == std::get<PocketTarget>(puzzle.target).pocket;
}

double success(Puzzle puzzle, const Physics& planned, const Physics& truth) {
  puzzle.physics = planned;
  const Answer answer = solve(puzzle);
  if (answer.shots.empty()) return 0;
  Random random(2);
  constexpr int tries = 200;
  int made = 0;
  for (int i = 0; i < tries; ++i) made += is_made(puzzle, truth, answer.shots[0].launch, random);
  return static_cast<double>(made) / tries;
}

}  // namespace

int main(int argc, char** argv) {
  const Scene scene = preset_scene("pool-9ft");
  Physics truth = scene.physics;
  truth.motion = SlideRoll{0.16, 0.007, 0.012};
  truth.cushion = Han2005{1.22 * scene.ball.body.radius, 0.77, 0.17};

  Random random(1);
  std::vector<Recording> filmed;
  for (int i = 0; i < 30; ++i) {
    ShotRequest shot{.id = fmt::format("{}", i), .table = scene.table, .physics = truth, .ball = scene.ball};
    shot.ball.at = {random.uniform(0.2, 2.3), random.uniform(0.2, 1.0)};
    shot.launch = {random.uniform(1.5, 4), radians(random.uniform(0, 360))};
    shot.spin = {.top = random.uniform(-0.5, 0.8), .side = random.uniform(-0.6, 0.6)};
    shot.until.time = 3;
    filmed.push_back(film(shot, simulate(shot), {.rate = 60, .noise = 0.002, .outliers = 0.05}, random));
  }
  const Fit fit = bankshot::fit(filmed);
  for (const FittedCoefficient& p : fit.parameters) fmt::print("{:<20} {:.3f}\n", p.name, p.value);

  Wish wish{.table = scene.table, .physics = truth, .ball = scene.ball, .cushions = {1, 2, {}}};
  wish.kind = Wish::Kind::pocket;
  constexpr int puzzles = 20;
  double usual = 0, learnt = 0, known = 0;
  for (int i = 0; i < puzzles; ++i) {
    const Puzzle puzzle = generate(wish, random).value().puzzle;
    usual += success(puzzle, scene.physics, truth) / puzzles;
    learnt += success(puzzle, fit.physics, truth) / puzzles;
    known += success(puzzle, truth, truth) / puzzles;
  }
  fmt::print("banks made: planned with usual values {:.0f} %, as learnt {:.0f} %, as it is {:.0f} %\n", 100 * usual,
             100 * learnt, 100 * known);
  if (argc > 1) std::ofstream(argv[1]) << draw(std::span(filmed).first(4), fit);
}
