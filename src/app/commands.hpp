// SPDX-License-Identifier: MIT
//
// One file per command: each adds itself to the command line and says what to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace bankshot::app {

using Run = std::function<int()>;

Run add_solve(CLI::App& app);
Run add_batch(CLI::App& app);
Run add_simulate(CLI::App& app);
Run add_verify(CLI::App& app);
Run add_generate(CLI::App& app);
Run add_map(CLI::App& app);
Run add_report(CLI::App& app);

}  // namespace bankshot::app
