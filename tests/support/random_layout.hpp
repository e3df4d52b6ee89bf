// SPDX-License-Identifier: MIT
//
// Random layouts of pool balls, for the measurements of position play.
#pragma once

#include <string>
#include <vector>

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/random_question.hpp"

namespace bankshot::test {

/// Returns a puzzle without target: the cue ball and so many balls at random places of pool-9ft, launches of 0.3 to
/// 6 m/s, and spin within half the radius as a game allows it.
inline Puzzle random_layout(Random& random, int balls) {
  const Scene scene = preset_scene("pool-9ft");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  std::vector<Ball> all;
  for (int k = 0; k <= balls; ++k)
    all.push_back({*free_place(random, scene.table, all, scene.ball.body), scene.ball.body, std::to_string(k)});
  p.ball.at = all.front().at;
  p.others.assign(all.begin() + 1, all.end());
  p.spin_range = SpinRange{{-1, 1}, {-0.75, 0.75}, {0, 0}};
  p.speed = {0.3, 6};
  p.noise.speed_share = 0;
  return p;
}

}  // namespace bankshot::test
