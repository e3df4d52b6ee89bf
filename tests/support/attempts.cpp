// SPDX-License-Identifier: MIT
#include "support/attempts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bankshot/plan/generate.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/scene/target.hpp"

namespace bankshot::test {
namespace {

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform(0, 1))) * std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

/// Returns the shot as the player strikes it when `shot` is meant.
ShotRequest struck(ShotRequest shot, const Player& player, Random& random) {
  const auto error = [&](const char* name) {
    const Habit& h = player.habits.at(name);
    return std::pair{h.sigma * normal(random), h.bias};
  };
  const auto [angle, left] = error("angle");
  const auto [speed, hard] = error("speed");
  const auto [side, right] = error("side");
  const auto [top, high] = error("top");
  shot.launch.angle = wrap_angle(shot.launch.angle + angle + left);
  shot.launch.speed = std::max(0.05, shot.launch.speed * (1 + hard) + speed);
  shot.spin.side += side + right;
  shot.spin.top += top + high;
  return shot;
}

ShotRequest random_shot(Random& random) {
  const Scene scene = preset_scene("pool-9ft");
  ShotRequest s{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  s.table.pockets.clear();
  const Vec2d size = scene.table.highest();
  constexpr double clear = 0.1;
  s.ball.at = {random.uniform(clear, size.x - clear), random.uniform(clear, size.y - clear)};
  s.launch = {random.uniform(1, 4), random.uniform(0, 2 * std::numbers::pi)};
  s.spin = {.top = random.uniform(-0.5, 0.8), .side = random.uniform(-0.5, 0.5)};
  return s;
}

/// Returns true when the simulator drops a ball into the pocket asked for, after an allowed number of cushions.
bool made(const Puzzle& puzzle, const ShotRequest& played) {
  const Trajectory t = simulate(played);
  const auto wanted = std::get<PocketTarget>(puzzle.target).pocket;
  const auto fell = std::ranges::find(t.events, EventKind::pocket, &Record::kind);
  return fell != t.events.end() && t.cushions >= puzzle.cushions.min && t.cushions <= puzzle.cushions.max &&
         (!wanted || fell->contact.index == *wanted);
}

Attempt at_puzzle(const Player& player, Random& random) {
  const Scene scene = preset_scene("pool-9ft");
  const auto generated = generate({.table = scene.table,
                                   .physics = scene.physics,
                                   .ball = scene.ball,
                                   .cushions = {0, 2, {}},
                                   .kind = Wish::Kind::pocket},
                                  random);
  const Shot& best = generated.value().answer.shots.at(0);
  Attempt out{.puzzle = generated->puzzle};
  ShotRequest& s = out.seen.scene;
  s = {.table = scene.table, .physics = scene.physics, .ball = generated->puzzle.ball};
  s.launch = best.launch, s.spin = best.spin;
  out.seen.launch_given = true;
  out.made = made(*out.puzzle, struck(s, player, random));
  return out;
}

}  // namespace

Player random_player(Random& random) {
  return {{{"angle", {radians(random.log_uniform(0.05, 0.4)), radians(random.uniform(-0.1, 0.1))}},
           {"speed", {random.log_uniform(0.03, 0.15), random.uniform(-0.04, 0.04)}},
           {"side", {random.log_uniform(0.02, 0.1), random.uniform(-0.05, 0.05)}},
           {"top", {random.log_uniform(0.02, 0.1), random.uniform(-0.05, 0.05)}}}};
}

std::vector<Attempt> attempts_of(const Player& player, const AttemptWish& wish, Random& random) {
  std::vector<Attempt> out;
  for (int i = 0; i < wish.attempts; ++i) {
    if (wish.made_only) {
      out.push_back(at_puzzle(player, random));
      continue;
    }
    const ShotRequest meant = random_shot(random);
    ShotRequest played = struck(meant, player, random);
    if (!wish.rests_only) played.until.time = wish.seconds;
    Attempt attempt{.seen = film(played, simulate(played), wish.camera, random)};
    if (wish.rests_only)
      for (Track& track : attempt.seen.tracks) track.samples.clear();
    attempt.seen.scene.launch = meant.launch, attempt.seen.scene.spin = meant.spin;
    attempt.seen.scene.physics = meant.physics;
    attempt.seen.scene.id = fmt::format("{}", i);
    attempt.seen.launch_given = true;
    out.push_back(attempt);
  }
  return out;
}

}  // namespace bankshot::test
