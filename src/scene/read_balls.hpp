// SPDX-License-Identifier: MIT
//
// The balls of a scene and the spin of a launch, which puzzles, shots and recordings have alike.
#pragma once

#include <vector>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "json/reader.hpp"

namespace bankshot {

/// The struck one; what is not said of it is as in `ball`.
Ball read_ball(const Reader& scene, Ball ball);

/// What is not said of them is as in the struck one.
std::vector<Ball> read_others(const Reader& scene, const Body& struck);

/// `printed`: answers print the natural roll that every shot has without the physics `spin`.
LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed);

}  // namespace bankshot
