// SPDX-License-Identifier: MIT
//
// Checks of an option's value: each returns what is wrong with it, or an empty text.
#pragma once

#include <string>

namespace bankshot::app {

/// Checks the name of a file to write. In "--svg --json" the file name is missing, and "-" would be standard output,
/// which carries the answer.
std::string file_name(const std::string& text);
/// Checks a file name likewise, but "-" may stand for standard output.
std::string file_or_output(const std::string& text);

/// Returns `jobs`, or the number of the machine's threads for 0.
int threads_for(int jobs);

}  // namespace bankshot::app
