// SPDX-License-Identifier: MIT
//
// Attempts of players whose noise and bias are known.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bankshot/scene/attempt.hpp"
#include "bankshot/simulate/camera.hpp"

namespace bankshot::test {

struct Habit {
  double sigma, bias;  ///< in the units of a PlayerError
};

struct Player {
  std::map<std::string, Habit> habits;  ///< keys: angle, speed, side, top
};

Player random_player(Random& random);

struct AttemptWish {
  int attempts = 50;
  double seconds = 3;
  Camera camera{.rate = 60, .noise = 2e-3, .outliers = 0.05};
  bool rests_only = false, made_only = false;
};

/// Draws attempts on a pool table. They are random shots or, with `made_only`, random puzzles of which only the outcome
/// is recorded.
std::vector<Attempt> attempts_of(const Player& player, const AttemptWish& wish, Random& random);

}  // namespace bankshot::test
