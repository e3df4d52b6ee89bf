// SPDX-License-Identifier: MIT
//
// The registry of commands. Each adds its options to the command line and returns the function to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace bankshot::app {

using Run = std::function<int()>;

/// A command line to type, and what it does.
struct Example {
  std::string line, what;
};

/// Writes the text below the options of `--help`; the manual page repeats it (manual/man.cpp, which knows its
/// headings).
void explain(CLI::App& command, const std::string& text, const std::vector<Example>& examples,
             const std::string& exit_codes);

// The commands, in the order of `--help`. Each has a namespace of its name with a function `add`, and nearly each a
// folder. `help`, `man` and `completion` are generated from the command line's own definitions.
#if BANKSHOT_LEARN
#define BANKSHOT_LEARNING(row) row(fit) row(advise)
#else
#define BANKSHOT_LEARNING(row)
#endif
#define BANKSHOT_COMMANDS(row)                                                                                       \
  row(solve) row(play) row(simulate) row(batch) row(verify) row(generate) row(map) row(pocket) row(book) row(report) \
      row(schema) row(serve) row(merge) BANKSHOT_LEARNING(row) row(help) row(man) row(completion)

#define BANKSHOT_DECLARE(name) \
  namespace name {             \
  Run add(CLI::App& app);      \
  }
BANKSHOT_COMMANDS(BANKSHOT_DECLARE)
#undef BANKSHOT_DECLARE

}  // namespace bankshot::app
