// SPDX-License-Identifier: MIT
//
// The batch pipeline: chunks of lines are read one after another, solved by several threads at once, and written in the
// order in which they were read. The number of chunks in progress is bounded, so memory does not grow with the input.
#pragma once

#include "app/batch/journal.hpp"
#include "app/batch/lines.hpp"
#include "app/batch/output.hpp"
#include "app/batch/tally.hpp"
#include "service/solve_flags.hpp"

namespace bankshot::app::batch {

struct Batch {
  LineReader& in;
  Output& out;
  Journal* journal;  ///< null if the output cannot be resumed
  const service::SolveFlags& flags;
  int threads;
  Progress& progress;
  Journal::Mark at;      ///< how far the batch has come
  Cost* cost = nullptr;  ///< measured if not null
};

/// Runs until the end of the input, an interrupt or an error. An error is thrown once the chunks in progress are
/// written. `batch.at` then says how much of the output is complete.
void run_pipeline(Batch& batch);

/// Returns the answer to one line as `solve --json` prints it, except that errors name the line of the file.
std::string answer_line(const Lines& lines, std::size_t i, const service::SolveFlags& flags);

}  // namespace bankshot::app::batch
