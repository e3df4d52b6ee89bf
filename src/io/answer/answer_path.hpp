// SPDX-License-Identifier: MIT
//
// Writes the points of a shot's path, up to its target.
#pragma once

#include "bankshot/plan/answer.hpp"
#include "io/json/writer.hpp"

namespace bankshot {

/// Writes the key "path" with [t, x, y] of the cue ball at each event and 60 times a second between events, and the key
/// "paths" for other balls that move.
void write_points(JsonWriter& w, const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot
