// SPDX-License-Identifier: MIT
//
// Reading puzzles and shots from JSON text, in the format of README. Degrees become radians here.
// Each function throws InvalidInput with the JSON path, the offending value and the rule; text
// that is no JSON has the path "" and a reason that begins with "line N".
#pragma once

#include <string_view>

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"

namespace bankshot {

Puzzle read_puzzle(std::string_view text);
ShotRequest read_shot(std::string_view text);

/// The puzzle as one line of JSON that `read_puzzle` reads back to the same numbers (degrees are
/// rounded to the nearest double). Every choice is written out, also those that are defaults.
std::string write_puzzle(const Puzzle& puzzle);

/// The same in short: table and physics as the JSON text they came from, no defaults.
std::string write_puzzle(const Puzzle& puzzle, std::string_view table, std::string_view physics);

/// A table and a physics, each the JSON text of a puzzle's member, and the ball that the table implies.
Scene read_scene(std::string_view table, std::string_view physics);

/// The JSON text of `id` in a document that may be invalid otherwise; empty when there is none.
std::string read_id(std::string_view text);

}  // namespace bankshot
