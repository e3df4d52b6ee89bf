// SPDX-License-Identifier: MIT
//
// Runs the bankshot program as a user would: arguments, standard input, exit code, both outputs.
#pragma once

#include <string>

namespace bankshot::test {

struct Run {
  int exit;
  std::string out, err;
};

/// `arguments` as typed in a shell.
Run run_program(const std::string& arguments, const std::string& input = "");

/// Several commands of a shell; the word PROGRAM stands for the program.
Run run_shell(std::string commands, const std::string& input = "");

/// A file below the repository.
std::string read_repository_file(const std::string& path);

}  // namespace bankshot::test
