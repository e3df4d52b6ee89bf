// SPDX-License-Identifier: MIT
#include <array>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

std::span<const Player> players() {
  static const std::array<Player, 3> all{{
      {"pro",
       {.angle = radians(0.06), .speed = 0, .speed_share = 0.02, .tip = 0.0005},
       "a tournament professional",
       "an assumption: half the aiming error of the Computer Olympiad's player"},
      {"league",
       {.angle = radians(0.2), .speed = 0, .speed_share = 0.05, .tip = 0.0015},
       "a good league player",
       "an assumption"},
      {"beginner",
       {.angle = radians(0.6), .speed = 0, .speed_share = 0.12, .tip = 0.004},
       "a beginner",
       "an assumption"},
  }};
  return all;
}

}  // namespace bankshot
