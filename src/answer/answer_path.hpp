// SPDX-License-Identifier: MIT
//
// The points of a shot's path, up to its target.
#pragma once

#include "bankshot/plan/answer.hpp"
#include "json/writer.hpp"

namespace bankshot {

/// The key "path" with [t, x, y] at each event and 60 times a second between them.
void write_points(JsonWriter& w, const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot
