// SPDX-License-Identifier: MIT
#include "service/start_map.hpp"

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/batch.hpp"
#include "bankshot/scene/in_hand.hpp"

namespace bankshot::service {

StartMap start_map(const Puzzle& puzzle, int columns, int rows, const SolveOptions& options) {
  StartMap map{StartGrid(puzzle, columns, rows), {}, {}};
  const Boundary boundary(puzzle.table, puzzle.ball.body, puzzle.others);
  std::vector<Puzzle> asked;
  for (std::size_t i = 0; i < map.grid.size(); ++i) {
    map.starts.push_back(start_at(puzzle, boundary, map.grid.at(i)));
    if (map.starts.back() != Start::legal) continue;
    asked.push_back(placed(puzzle, map.grid.at(i)));
  }
  SolveOptions each = options;
  each.suggest = false;
  std::vector<Answer> found = solve_batch(asked, {.solve = each});
  auto next = found.begin();
  for (const Start start : map.starts)
    map.answers.push_back(start == Start::legal ? std::move(*next++) : Answer{.status = Status::invalid});
  return map;
}

}  // namespace bankshot::service
