// SPDX-License-Identifier: MIT
//
// 01: simulate one shot and read its events.
// The scene is that of the seed article: 2.5 × 1.25 m, friction 0.05, no loss at the cushions. A ball leaves
// (0.2, 0.2) with 5 m/s at 45 degrees.
#include <fmt/format.h>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"

int main() {
  using namespace bankshot;
  const ShotRequest shot{.table = make_table(*find_table_preset("seed")),
                         .physics = {Rolling{.friction = 0.05}, Mirror{.restitution = 1}},
                         .ball = {.at = {0.2, 0.2}, .body = {.radius = 0.0285, .mass = 0.17}},
                         .launch = {.speed = 5, .angle = radians(45)}};
  const Trajectory path = simulate(shot);
  for (const Record& e : path.events)
    if (e.kind == EventKind::cushion)
      fmt::print("{:8.5f} s  {:<6}  ({:.5f}, {:.5f})\n", e.time, contact_name(shot.table, e.contact), e.state.at.x,
                 e.state.at.y);
  const Record& rest = path.events.back();
  fmt::print("rests at ({:.5f}, {:.5f}) after {:.5f} s and {:.5f} m\n", rest.state.at.x, rest.state.at.y, rest.time,
             path.length);
}
