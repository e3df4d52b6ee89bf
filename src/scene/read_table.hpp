// SPDX-License-Identifier: MIT
#pragma once

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"
#include "json/reader.hpp"

namespace bankshot {

/// The ball that a table document implies: the preset's, else the default one.
Ball default_ball(const Reader& table);

/// Of a name, or of an object that changes it; null where the table is one's own.
const TablePreset* preset_of(const Reader& table);

/// `radius` is the struck ball's: mouths of "six" on a custom table scale with it.
Table read_table(const Reader& table, double radius);

}  // namespace bankshot
