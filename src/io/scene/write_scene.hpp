// SPDX-License-Identifier: MIT
//
// Writes parts of a scene as JSON that reads back to them, with every choice written out.
#pragma once

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/table.hpp"
#include "io/json/document.hpp"

namespace bankshot {

/// Returns [x, y].
Json pair_json(const Vec2d& p);

/// Returns the identifier as JSON; null if it is empty.
Json id_json(const std::string& id);

/// Returns a table, with the tilt of the physics. A preset is written by its name.
Json table_json(const Table& table, const Vec2d& tilt);

/// Returns a ball with its position, radius and mass.
Json ball_json(const Ball& ball);
/// Returns the other balls, without values that equal the cue ball's.
Json others_json(const std::vector<Ball>& others, const Body& struck);

Json spin_json(const LaunchSpin& spin);
/// Returns a launch, with the angle in degrees.
Json launch_json(const Launch& launch, const LaunchSpin& spin);

/// Returns the physics. Throws InvalidInput for a custom cushion.
Json physics_json(const Physics& physics);

}  // namespace bankshot
