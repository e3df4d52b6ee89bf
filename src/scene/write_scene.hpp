// SPDX-License-Identifier: MIT
//
// Parts of a scene as the JSON that is read back to them, every choice written out.
#pragma once

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/table.hpp"
#include "json/document.hpp"

namespace bankshot {

/// [x, y]
Json pair_json(const Vec2d& p);

/// Null where there is none.
Json id_json(const std::string& id);

/// The tilt of the physics stands with the table. A preset is told by its name.
Json table_json(const Table& table, const Vec2d& tilt);

/// Where it stands and what it is.
Json ball_json(const Ball& ball);
/// What is as in the struck one is not said.
Json others_json(const std::vector<Ball>& others, const Body& struck);

Json spin_json(const LaunchSpin& spin);
/// The angle in degrees.
Json launch_json(const Launch& launch, const LaunchSpin& spin);

/// Throws InvalidInput for a custom cushion.
Json physics_json(const Physics& physics);

}  // namespace bankshot
