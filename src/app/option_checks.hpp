// SPDX-License-Identifier: MIT
//
// Checks of an option's value: what is wrong with it, or nothing.
#pragma once

#include <string>

namespace bankshot::app {

/// A file to write. "--svg --json" would write a file of that name, and standard output carries the answer.
std::string file_name(const std::string& text);
/// The same where "-" may take the text's place.
std::string file_or_output(const std::string& text);
/// At least 0; CLI11's own check prints its bounds with 309 digits.
std::string whole_number(const std::string& text);

/// As many threads as asked for; 0: as the machine has.
int threads_for(int jobs);

}  // namespace bankshot::app
