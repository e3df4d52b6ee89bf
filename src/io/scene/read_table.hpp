// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"
#include "io/json/reader.hpp"

namespace bankshot {

/// Returns the ball that a table document implies: the preset's, or else the default ball.
Ball default_ball(const Reader& table);

/// Returns the preset that a table names or changes; null for a custom table.
const TablePreset* preset_of(const Reader& table);

/// Reads a table. `radius` is the cue ball's; the mouths of "six" pockets on a custom table scale with it.
Table read_table(const Reader& table, double radius);

}  // namespace bankshot
