// SPDX-License-Identifier: MIT
//
// Where on the table can a shot be made from? One puzzle, asked from every point of a grid.
#pragma once

#include <string>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"

namespace bankshot {

/// Why no puzzle is asked from here.
enum class Start { legal, cushion, pocket, ball, target };
const char* name(Start start);

/// The grid's cells tile the box of all places of the ball's centre, row by row from the lower left; the ball
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
  std::vector<Answer> answers;  ///< status `invalid` where the start is not legal
};

/// Whether a ball can start here: clear of cushions, outside every pocket, not at its target already.
Start start_at(const Puzzle& puzzle, const Boundary& boundary, const Vec2d& at);

/// x_m,y_m,status,... one row a cell, with a header that names the units.
std::string to_csv(const Puzzle& puzzle, const StartMap& map);

}  // namespace bankshot
