// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

/// Returns a puzzle with a sliding ball that goes off the top rail to a point, which it passes at 0.5 m/s.
inline Puzzle bank() {
  Puzzle p{.table = rectangle_table(2.54, 1.27), .physics = spin_physics(), .ball = {.at = {0.635, 0.4}}};
  p.spin = {.top = 0.3, .side = 0.4};
  p.target = PointTarget{{1.8, 0.72}, 0.02};
  p.arrive = Range{0.5, 0.5};
  p.cushions = CushionRule::in_order({Contact::rail(2)});
  return p;
}

/// Returns a launch of the bank that passes within a few centimetres of its point.
inline Launch near_bank(double speed) { return {speed, radians(55)}; }

}  // namespace bankshot::test
