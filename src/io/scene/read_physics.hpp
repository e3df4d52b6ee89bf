// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "io/json/reader.hpp"

namespace bankshot {

Restitution read_restitution(const Reader& r);

/// Reads the physics of a document. Defaults depend on the table and on the balls.
Physics read_physics(const Reader& scene, const Ball& ball, const std::vector<Ball>& others = {});

}  // namespace bankshot
