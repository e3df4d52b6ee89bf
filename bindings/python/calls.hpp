// SPDX-License-Identifier: MIT
//
// The module's calls to the planners: texts in, texts out, without the GIL and interruptible by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/generate/wishes.hpp"
#include "app/solve/solve_flags.hpp"
#include "bankshot/plan/answer.hpp"
#if BANKSHOT_LEARN
#include "bankshot/learn/fit.hpp"
#endif

namespace bankshot::python {

using Texts = std::vector<std::string>;
using app::solve::SolveFlags;

/// A puzzle and its answer.
struct Solved {
  Puzzle puzzle;
  Answer answer;
  bool timing, path;

  std::string json() const { return to_json(puzzle, answer, timing, path); }
  std::string text() const { return to_text(puzzle, answer); }
};

/// Throws InvalidInput for invalid flags.
void check(const SolveFlags& flags);

Solved solved(const std::string& text, const SolveFlags& flags);

/// Returns a line of JSON for each puzzle. Unless `tell` is None, it is called from time to time with the number done.
Texts solve_lines(const Texts& lines, const SolveFlags& flags, int threads, pybind11::object tell);

struct NotFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns puzzles, one per line. Throws NotFound.
Texts generate_lines(const app::generate::Wishes& wishes, long count, int threads);

/// Returns as CSV the starts from which a shot can be made.
std::string map(const std::string& text, int columns, int rows, const SolveFlags& flags);

#if BANKSHOT_LEARN
/// Fits recordings, one per line. Ctrl-C takes effect between steps.
std::string fit(const Texts& lines, FitWish wish);
#endif

}  // namespace bankshot::python
