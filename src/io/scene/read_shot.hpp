// SPDX-License-Identifier: MIT
//
// Reads the parts that puzzles, shots and recordings share: id, scene and launch.
#pragma once

#include <string>
#include <vector>

#include "bankshot/scene/puzzle.hpp"
#include "io/json/reader.hpp"

namespace bankshot {

/// Returns the id as it was `written`; throws if it is neither a string nor a number.
std::string read_id(const Reader& doc, std::string written);

/// Returns the unit of a document's positions and lengths. Diamonds need a rectangle.
Units read_units(const Reader& doc);

/// Reads table, physics and balls of a Puzzle or a ShotRequest.
template <class Scene>
void read_setting(const Reader& doc, Scene& scene);

/// Reads a launch spin. With `printed`, natural roll is allowed without the physics `spin`, because answers print it.
LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed);

/// Reads "shot"; if it has no spin, reads the ball's. Returns false if there is no "shot".
bool read_launch(const Reader& doc, ShotRequest& shot);

/// Reads a list of cushions in order.
std::vector<Contact> read_sequence(const Reader& list, const Table& table);

}  // namespace bankshot
