// SPDX-License-Identifier: MIT
//
// Reading puzzles and shots from JSON text. Lengths, speeds and masses are SI as in scene/puzzle.hpp; angles are
// degrees there and become radians here. What is not given has the default of the struct it is read into, but for
// physics, and for the radius and the mass of a ball on a table_presets() table, which are the preset's.
//   puzzle   table, ball and target are required; id about physics cushions arrive speed angle prefer aim noise budget
//     table    a name of table_presets(), {"length", "width", "pockets"} or {"vertices", "names", "pockets"};
//              pockets "none", "six" (then also "mouth": {"corner", "middle"}) or [{"name", "at", "radius"}, ...]
//     physics  "ideal", "rolling", "spin" (the default), or {"model": one of them, coefficients}; those of "spin" hold
//              "cushion": {"model": "han2005", "mathavan2010" or "mirror", coefficients}
//     ball     {"at": [x, y], "radius", "mass", "spin": {"top", "side", "masse"}}; a spin may be a range [low, high]
//     target   {"point": [x, y], "within"} or {"pocket": a name or "any"}
//     cushions a number, a list of names, or {"min", "max"};  arrive {"speed"};  speed, angle ranges
//     prefer "robust" "soft" "quick";  aim "centre" "safest";  noise {"angle", "speed"};  budget {"simulations"}
//   shot     table, ball and "shot": {"speed", "angle", "spin"} are required; id physics until; a puzzle with a shot of
//   its
//            answer is one too, what else stands in them is not read
//     until    {"time", "cushions", "length"}: where to stop
// docs/format.md has every key with its default, `bankshot schema` prints them as a JSON Schema. A range is [low, high]
// or one number. examples/puzzles holds some. Each function throws InvalidInput with the JSON path, the offending value
// and the rule; text that is no JSON has the path "" and a reason that begins with "line N".
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
/// The same of `about`, in a document that is JSON.
std::string read_about(std::string_view text);

}  // namespace bankshot
