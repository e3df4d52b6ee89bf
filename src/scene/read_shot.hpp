// SPDX-License-Identifier: MIT
//
// What puzzles, shots and recordings have alike: who they are, the scene and its launch.
#pragma once

#include <string>
#include <vector>

#include "bankshot/scene/puzzle.hpp"
#include "json/reader.hpp"

namespace bankshot {

/// As it was `written` where the document has none of its own for it.
std::string read_id(const Reader& doc, std::string written);

/// Table, physics and balls of a Puzzle or a ShotRequest.
template <class Scene>
void read_setting(const Reader& doc, Scene& scene);

/// `printed`: answers print the natural roll that every shot has without the physics `spin`.
LaunchSpin read_spin(const Reader& r, const Physics& physics, bool printed);

/// "shot", and the spin that stands with the ball where that has none. False where there is no "shot".
bool read_launch(const Reader& doc, ShotRequest& shot);

/// A list of cushions in order.
std::vector<Contact> read_sequence(const Reader& list, const Table& table);

}  // namespace bankshot
