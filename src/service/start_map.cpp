// SPDX-License-Identifier: MIT
#include "service/start_map.hpp"

#include "bankshot/plan/batch.hpp"
#include "bankshot/scene/in_hand.hpp"

namespace bankshot::service {

StartMap start_map(const Puzzle& puzzle, int columns, int rows, const SolveOptions& options) {
  const StartGrid grid(puzzle, columns, rows);
  StartMap map{grid, starts_on(puzzle, grid), {}};
  std::vector<Puzzle> asked;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (map.starts[i] == Start::legal) asked.push_back(placed(puzzle, grid.at(i)));
  SolveOptions each = options;
  each.suggest = false;
  std::vector<Answer> found = solve_batch(asked, {.solve = each});
  auto next = found.begin();
  for (const Start start : map.starts)
    map.answers.push_back(start == Start::legal ? std::move(*next++) : Answer{.status = Status::invalid});
  return map;
}

}  // namespace bankshot::service
