// SPDX-License-Identifier: MIT
//
// The module's calls to the planners: texts in, texts out, without the GIL and interruptible by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "bankshot/plan/answer.hpp"
#include "service/solve_flags.hpp"
#include "service/wishes.hpp"
#if BANKSHOT_LEARN
#include "bankshot/learn/fit.hpp"
#endif

namespace bankshot::python {

using Texts = std::vector<std::string>;
using service::SolveFlags;

/// A puzzle and its answer.
struct Solved {
  Puzzle puzzle;
  Answer answer;
  SolveFlags flags;

  std::string json() const { return to_json(puzzle, answer, !flags.no_timing, flags.path); }
  std::string text() const { return service::text_of(puzzle, answer, flags); }
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
Texts generate_lines(const service::Wishes& wishes, long count, int threads);

/// Returns as CSV the starts from which a shot can be made.
std::string map(const std::string& text, int columns, int rows, const SolveFlags& flags, bool value);

#if BANKSHOT_LEARN
/// Fits recordings, one per line. Ctrl-C takes effect between steps.
std::string fit(const Texts& lines, FitWish wish);
#endif

}  // namespace bankshot::python
