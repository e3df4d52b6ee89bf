// SPDX-License-Identifier: MIT
//
// The options that the command line knows, for the manual pages and shell completions.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace bankshot::app::manual {

struct Option {
  std::vector<std::string> names{};    ///< with their dashes; empty for a positional argument
  std::string place{};                 ///< name of a positional argument
  std::string value{};                 ///< the placeholder after the name in --help; empty for a flag
  std::vector<std::string> choices{};  ///< the allowed values, if they are a fixed list
  std::string meaning{}, fallback{};
};

/// Returns the options in the order of --help, without hidden ones.
std::vector<Option> options(const CLI::App& command);
std::vector<const CLI::App*> commands(const CLI::App& app);

}  // namespace bankshot::app::manual
