// SPDX-License-Identifier: MIT
#include "app/option_checks.hpp"

#include <algorithm>
#include <thread>

namespace bankshot::app {

std::string file_name(const std::string& text) {
  if (text == "-") return "\"-\" is standard output, which carries the answer; name a file";
  return file_or_output(text);
}

std::string file_or_output(const std::string& text) {
  return text.starts_with("--") ? "\"" + text + "\" is an option, not a file" : "";
}

int threads_for(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace bankshot::app
