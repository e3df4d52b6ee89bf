// SPDX-License-Identifier: MIT
#include "bankshot/scene/physics.hpp"

namespace bankshot {

Physics spin_physics(double radius) {
  return {SlideRoll{.radius = radius, .spinning_friction = 4.0 / 9 * radius},
          Han2005{.radius = radius, .height = 1.28 * radius}};
}

}  // namespace bankshot
