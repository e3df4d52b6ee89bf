// SPDX-License-Identifier: MIT
#include "bankshot/plan/batch.hpp"

#include "planners/in_parallel.hpp"

namespace bankshot {
namespace {

Answer solve_one(const Puzzle& puzzle, const SolveOptions& options) {
  try {
    return solve(puzzle, options);
  } catch (const InvalidInput& e) {
    return invalid_answer(puzzle.id, e, puzzle.about);
  } catch (const std::exception& e) {
    return invalid_answer(puzzle.id, InvalidInput("", std::string("this puzzle could not be worked on: ") + e.what()),
                          puzzle.about);
  }
}

}  // namespace

std::vector<Answer> solve_batch(std::span<const Puzzle> puzzles, const BatchOptions& options) {
  std::vector<Answer> answers(puzzles.size());
  planning::for_each_index(puzzles.size(), options.threads,
                           [&](std::size_t i) { answers[i] = solve_one(puzzles[i], options.solve); });
  return answers;
}

}  // namespace bankshot
