// SPDX-License-Identifier: MIT
//
// Reads puzzles and shots from JSON text. Lengths, speeds and masses are SI as in scene/puzzle.hpp; angles are degrees
// in JSON and radians in the structs. A missing key takes the default of its struct, with two exceptions: the physics,
// and the radius and mass of a ball on a preset table, which come from the preset.
//   puzzle   table, ball and target are required; optional: id about physics others settle cushions arrive speed angle
//            prefer aim noise budget
//     table    a name of table_presets(), {"length", "width", "pockets"} or {"vertices", "names", "pockets"};
//              pockets "none", "six" (then also "mouth": {"corner", "middle"}) or [{"name", "at", "radius"}, ...]
//     physics  "ideal", "rolling", "spin" (the default), or {"model": one of them, coefficients}; those of "spin" hold
//              "cushion": {"model": a key of contact/cushion_registry.hpp, coefficients}
//     ball     {"at": [x, y], "radius", "mass", "spin": {"top", "side", "masse"}}; a spin may be a range [low, high]
//     target   {"point": [x, y], "within"}, {"pocket": a name or "any"}, {"ball": names, "cut", "within", "then"} or
//              {"carom": [first, second], "cut", "within"}
//     cushions a number, a list of names, or {"min", "max"};  arrive {"speed"};  speed a range;  angle [from, to]
//     prefer "robust" "soft" "quick" {"leave"};  aim "centre" "safest";  noise {"angle", "speed"} or a player;
//            budget {"simulations"}
//   shot     table, ball and "shot": {"speed", "angle"} are required; optional: its "spin", id physics until. A puzzle
//            joined with a shot of its answer is also valid; other keys of the two are ignored.
//     until    {"time", "cushions", "length"}: where to stop
// docs/format.md lists every key with its default; `bankshot schema` prints them as a JSON Schema. A range is
// [low, high] or one number. See examples/puzzles. Each function throws InvalidInput with the JSON path, the offending
// value and the rule. For text that is not JSON, the path is "" and `line` is set.
#pragma once

#include <string_view>

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"

namespace bankshot {

Puzzle read_puzzle(std::string_view text);
ShotRequest read_shot(std::string_view text);

/// Returns the puzzle as one line of JSON that `read_puzzle` reads back to the same numbers (degrees are
/// rounded to the nearest double). Every choice is written, including defaults.
std::string write_puzzle(const Puzzle& puzzle);

/// Returns the puzzle in short form: table and physics as the given JSON text, and no defaults.
std::string write_puzzle(const Puzzle& puzzle, std::string_view table, std::string_view physics);

/// Reads a table and a physics, each given as the JSON text of a puzzle's member. The ball is the table's default.
Scene read_scene(std::string_view table, std::string_view physics);

/// Returns the JSON text of `id` in a document that may otherwise be invalid; empty if there is none.
std::string read_id(std::string_view text);
/// Returns the JSON text of `about` in a document that is valid JSON; empty if there is none.
std::string read_about(std::string_view text);

}  // namespace bankshot
