// SPDX-License-Identifier: MIT
//
// The answer to one document, which `solve` and `play` print.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/picture.hpp"
#include "service/solve_flags.hpp"

namespace bankshot::app::solve {

struct Arguments {
  std::string file = "-", csv;
  service::SolveFlags flags;
  PictureFlags picture;
  bool json = false;
};

/// Adds the options that say how to answer.
void add_arguments(CLI::App& command, Arguments& a);

/// Makes a puzzle of a document; throws InvalidInput.
using Asked = std::function<std::string(const std::string& text)>;

/// Reads a document, answers it and prints the answer; returns the exit code. Without `asked` it is a puzzle.
int run(const Arguments& a, const Asked& asked = {});

}  // namespace bankshot::app::solve
