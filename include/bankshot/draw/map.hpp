// SPDX-License-Identifier: MIT
//
// Heat maps on a table: cells in colours, with the scale below; and the map of a puzzle's starts.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/plan/start_map.hpp"

namespace bankshot {

struct Cell {
  Vec2d low, high;  ///< corners [m]
  std::string fill;
  std::optional<double> aim{};  ///< rad; drawn as an arrowhead in the middle, where the cell has room for it ...
  std::string ink = "#fff";     ///< ... in this colour
};

struct LegendEntry {
  std::string label, colour;
};

/// The puzzle's table and target under coloured cells.
std::string draw(const Puzzle& puzzle, std::span<const Cell> cells, std::span<const LegendEntry> legend,
                 const std::string& title, const PictureStyle& style = {});

/// Two tables one above the other: how likely the best shot from each start is made, and how slow it is.
/// Without success the second alone. Cells without a shot are holes; where no ball can start the cloth is seen.
std::string draw(const Puzzle& puzzle, const StartMap& map, Theme theme = Theme::light);

}  // namespace bankshot
