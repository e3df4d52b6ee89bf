// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

/// Returns a puzzle with a ball that rolls 1 m straight to a point, which it passes at 0.5 m/s.
inline Puzzle straight() {
  Puzzle p{.table = rectangle_table(2, 1), .physics = rolling_physics(), .ball = {.at = {0.5, 0.5}}};
  p.target = PointTarget{{1.5, 0.5}, 0.01};
  p.arrive = Range{0.5, 0.5};
  p.cushions = CushionRule::exactly(0);
  return p;
}

}  // namespace bankshot::test
