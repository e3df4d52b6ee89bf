// SPDX-License-Identifier: MIT
//
// A map of the starts from which a puzzle can be solved, as data. `bankshot map` and the bindings compute it: they
// solve the puzzle from every point of a grid.
#pragma once

#include <string>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"

namespace bankshot {

/// `legal`, or the reason why a ball cannot start here.
enum class Start { legal, cushion, pocket, ball, target };
const char* name(Start start);

/// The cells tile the bounding box of all positions of the ball's centre, row by row from the lower left. The ball
/// starts in the middle of a cell.
struct StartGrid {
  StartGrid(const Puzzle& puzzle, int columns, int rows);
  int columns, rows;
  Vec2d low, cell;  ///< lower left corner, size of a cell [m]

  Vec2d at(std::size_t i) const;
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

struct StartMap {
  StartGrid grid;
  std::vector<Start> starts;
  std::vector<Answer> answers;  ///< status `invalid` if the start is not legal
};

/// Returns `legal` if a ball can start here: clear of cushions and balls, outside every pocket, not yet at its target.
Start start_at(const Puzzle& puzzle, const Boundary& boundary, const Vec2d& at);

/// Returns `start_at` for each cell.
std::vector<Start> starts_on(const Puzzle& puzzle, const StartGrid& grid);

/// Returns one CSV row per cell (x_m,y_m,status,...), with a header that names the units.
std::string to_csv(const Puzzle& puzzle, const StartMap& map);

}  // namespace bankshot
