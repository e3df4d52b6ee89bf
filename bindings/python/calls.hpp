// SPDX-License-Identifier: MIT
//
// What the module asks of the planners: texts in, texts out, without the GIL and until Ctrl-C.
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

/// Throws InvalidInput where they cannot be meant.
void check(const SolveFlags& flags);

Solved solved(const std::string& text, const SolveFlags& flags);

/// A line of JSON for each; tells `tell`, unless it is None, from time to time how many there are.
Texts solve_lines(const Texts& lines, const SolveFlags& flags, int threads, pybind11::object tell);

struct NotFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Puzzles, a line each. Throws NotFound.
Texts generate_lines(const app::generate::Wishes& wishes, long count, int threads);

/// From where on the table a shot can be made, as CSV.
std::string map(const std::string& text, int columns, int rows, const SolveFlags& flags);

#if BANKSHOT_LEARN
/// Of recordings, a line each. Ctrl-C is heard between steps.
std::string fit(const Texts& lines, FitWish wish);
#endif

}  // namespace bankshot::python
