// SPDX-License-Identifier: MIT
//
// Runs the bankshot program as a user would: with arguments, standard input, exit code and both outputs.
#pragma once

#include <string>

namespace bankshot::test {

struct Run {
  int exit;
  std::string out, err;
};

/// Runs the program with `arguments` as typed in a shell.
Run run_program(const std::string& arguments, const std::string& input = "");

/// Runs shell commands; the word PROGRAM stands for the program.
Run run_shell(std::string commands, const std::string& input = "");

/// Returns the text of a file of the repository.
std::string read_repository_file(const std::string& path);

}  // namespace bankshot::test
