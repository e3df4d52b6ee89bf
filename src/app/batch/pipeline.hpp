// SPDX-License-Identifier: MIT
//
// Lines in, answers out: chunks of lines are read one after another, worked on by several threads at
// once, and written in the order they were read. A bounded number of chunks is under way, so memory
// does not grow with the input.
#pragma once

#include "app/batch/journal.hpp"
#include "app/batch/lines.hpp"
#include "app/batch/output.hpp"
#include "app/batch/tally.hpp"
#include "app/solve/solve_flags.hpp"

namespace bankshot::app::batch {

struct Batch {
  LineReader& in;
  Output& out;
  Journal* journal;  ///< none where the output cannot be gone on with
  const solve::SolveFlags& flags;
  int threads;
  Progress& progress;
  Journal::Mark at;      ///< how far it has come
  Cost* cost = nullptr;  ///< filled where given
};

/// Runs until the end of the input, an interrupt, or an error, which it throws once what was under
/// way is written. `batch.at` then says how far the output is whole.
void run_pipeline(Batch& batch);

/// The answer to one line, as `solve --json` prints it, but that it names the line of the file.
std::string answer_line(const Lines& lines, std::size_t i, const solve::SolveFlags& flags);

}  // namespace bankshot::app::batch
