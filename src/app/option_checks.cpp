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

std::string whole_number(const std::string& text) {
  constexpr std::size_t most_digits = 18;  // fits a long
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits && text.size() <= most_digits ? "" : "\"" + text + "\" must be a whole number, at least 0";
}

int threads_for(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace bankshot::app
