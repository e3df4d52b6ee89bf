// SPDX-License-Identifier: MIT
//
// 04: simulate one shot with three cushion models. The mirror keeps spin and tangential speed; in Han (2005) and
// Mathavan (2010), friction converts one into the other. One new idea: choosing the physics.
#include <fmt/format.h>

#include <fstream>

#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  Scene scene = preset_scene("carom-10ft");
  scene.ball.at = {0.5, 0.4};
  const Han2005 han = std::get<Han2005>(scene.physics.cushion);
  const std::pair<const char*, decltype(Physics::cushion)> models[] = {
      {"mirror", Mirror{han.restitution}},
      {"han2005", han},
      {"mathavan2010", Mathavan2010{.height = han.height, .restitution = han.restitution}},
  };
  std::vector<LabelledPath> paths;
  for (const auto& [name, cushion] : models) {
    scene.physics.cushion = cushion;
    const ShotRequest shot{.table = scene.table,
                           .physics = scene.physics,
                           .ball = scene.ball,
                           .launch = {3.5, radians(35)},
                           .spin = {.top = 0.5, .side = 0.8}};
    const Trajectory path = simulate(shot);
    const Vec2d rest = path.events.back().state.at;
    fmt::print("{:<13} rests at ({:.3f}, {:.3f}) m after {:.2f} s and", name, rest.x, rest.y, path.events.back().time);
    for (const Contact cushion_met : path.sequence()) fmt::print(" {}", contact_name(shot.table, cushion_met));
    fmt::print("\n");
    paths.push_back({name, path});
  }
  if (argc > 1) std::ofstream(argv[1]) << draw(scene.table, scene.ball, paths);
}
