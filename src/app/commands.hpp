// SPDX-License-Identifier: MIT
//
// One file per command: each adds its command to the command line and returns the function to run.
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

// Each command has a folder and a namespace of its own.
namespace solve {
Run add(CLI::App& app);
}
namespace batch {
Run add(CLI::App& app);
}
namespace merge {
Run add(CLI::App& app);
}
namespace simulate {
Run add(CLI::App& app);
}
namespace verify {
Run add(CLI::App& app);
}
namespace generate {
Run add(CLI::App& app);
}
namespace map {
Run add(CLI::App& app);
}
namespace pocket {
Run add(CLI::App& app);
}
namespace report {
Run add(CLI::App& app);
}
namespace book {
Run add(CLI::App& app);
}
namespace schema {
Run add(CLI::App& app);
}
namespace serve {
Run add(CLI::App& app);
}
#if BANKSHOT_LEARN
namespace fit {
Run add(CLI::App& app);
}
namespace advise {
Run add(CLI::App& app);
}
#endif
// These are generated from the command line's own definitions.
namespace manual {
Run add_help(CLI::App& app);
Run add_man(CLI::App& app);
Run add_completion(CLI::App& app);
}  // namespace manual

}  // namespace bankshot::app
