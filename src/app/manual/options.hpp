// SPDX-License-Identifier: MIT
//
// What the command line knows of its options, for whoever writes about them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace bankshot::app::manual {

struct Option {
  std::vector<std::string> names{};    ///< with their dashes; empty for one that is told by its place
  std::string place{};                 ///< the name of that place
  std::string value{};                 ///< what follows the name, as --help says it; empty for a flag
  std::vector<std::string> choices{};  ///< the values, where they are known
  std::string meaning{}, fallback{};
};

/// In the order of --help, without hidden ones.
std::vector<Option> options(const CLI::App& command);
std::vector<const CLI::App*> commands(const CLI::App& app);

}  // namespace bankshot::app::manual
