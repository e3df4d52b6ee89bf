// SPDX-License-Identifier: MIT
#include "bankshot/plan/batch.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>

namespace bankshot {
namespace {

/// Puzzles that a thread takes at once: enough that the counter costs nothing, few enough to spread hard ones.
constexpr std::size_t block = 8;

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
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (;;) {
      const std::size_t begin = next.fetch_add(block, std::memory_order_relaxed);
      if (begin >= puzzles.size()) return;
      for (std::size_t i = begin; i < std::min(begin + block, puzzles.size()); ++i)
        answers[i] = solve_one(puzzles[i], options.solve);
    }
  };
  const std::size_t wanted = options.threads > 0 ? static_cast<std::size_t>(options.threads)
                                                 : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(wanted, (puzzles.size() + block - 1) / block);
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < threads) others.emplace_back(work);
  } catch (const std::system_error&) {
    // The system has no more threads to give; the others do the work.
  }
  work();
  others.clear();  // joins
  return answers;
}

}  // namespace bankshot
