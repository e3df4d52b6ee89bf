// SPDX-License-Identifier: MIT
//
// A table, the laws it is played by and the ball that is played on it, by their names.
//   Scene scene = preset_scene("snooker-12ft");            // or ..., "rolling")
//   scene.ball.at = {0.7, 0.5};
#pragma once

#include <string_view>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/scene/table.hpp"

namespace bankshot {

struct Scene {
  Table table{};
  Physics physics{};
  Ball ball{};
};

/// What the same names mean in a file: the preset's table, its ball, and `ideal`, `rolling` or `spin` for that ball and
/// those cushions. Throws InvalidInput where there is no such name.
Scene preset_scene(std::string_view table, std::string_view physics = "spin");

}  // namespace bankshot
