// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <span>

#include "service/options.hpp"

namespace bankshot::app {

/// Adds the options of a request to the command line.
void add_options(CLI::App& command, std::span<const service::Option> options);

}  // namespace bankshot::app
