// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "json/reader.hpp"

namespace bankshot {

Restitution read_restitution(const Reader& r);

/// What a document says of its physics; what it does not say depends on its table and on the balls.
Physics read_physics(const Reader& scene, const Ball& ball, const std::vector<Ball>& others = {});

}  // namespace bankshot
