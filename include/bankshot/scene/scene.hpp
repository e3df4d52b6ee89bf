// SPDX-License-Identifier: MIT
//
// A scene: a table, its physics and the ball played on it. Presets are available by name.
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

/// Returns the scene that these names mean in a file: the preset's table and ball, and the physics `ideal`, `rolling`
/// or `spin` for that ball and those cushions. Throws InvalidInput for an unknown name.
Scene preset_scene(std::string_view table, std::string_view physics = "spin");

}  // namespace bankshot
