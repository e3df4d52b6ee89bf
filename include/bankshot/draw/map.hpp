// SPDX-License-Identifier: MIT
//
// Heat maps on a table: coloured cells with a legend below, and the maps of a puzzle's starts.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/plan/place_value.hpp"
#include "bankshot/plan/start_map.hpp"

namespace bankshot {

struct Cell {
  Vec2d low, high;  ///< corners [m]
  std::string fill;
  std::optional<double> aim{};  ///< rad; drawn as an arrowhead in the middle if the cell is large enough
  std::string ink = "#fff";     ///< colour of the arrowhead
};

struct LegendEntry {
  std::string label, colour;
};

/// Draws the puzzle's table, target and other balls with coloured cells.
std::string draw(const Puzzle& puzzle, std::span<const Cell> cells, std::span<const LegendEntry> legend,
                 const std::string& title, const PictureStyle& style = {});

/// Draws two tables one above the other: the success of the best shot from each start, and its launch speed. If no
/// success was computed, only the second is drawn. Cells without a shot are left blank; the cloth shows where no ball
/// can start.
std::string draw(const Puzzle& puzzle, const StartMap& map, Theme theme = Theme::light);

/// Draws one table with the value of each place. The cloth shows where no ball can start.
std::string draw(const Puzzle& puzzle, const ValueMap& map, Theme theme = Theme::light);

}  // namespace bankshot
