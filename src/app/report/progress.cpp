// SPDX-License-Identifier: MIT
#include "app/report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace bankshot::app::report {

Progress::Progress(int parts) : terminal_(isatty(STDERR_FILENO) == 1), parts_(parts) {}

Progress::~Progress() {
  if (!terminal_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

void Progress::begin(const std::string& name, std::size_t steps) {
  name_ = name;
  steps_ = steps;
  done_ = 0;
  ++part_;
  shown_ = -1;
  show();
}

void Progress::step() {
  ++done_;
  show();
}

void Progress::show() {
  if (!terminal_) return;
  constexpr int width = 40;
  const double within = steps_ ? static_cast<double>(done_) / static_cast<double>(steps_) : 0;
  const double all = (part_ - 1 + within) / parts_;
  const int percent = static_cast<int>(100 * all), filled = static_cast<int>(width * all);
  if (percent == shown_) return;
  shown_ = percent;
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  fmt::print(stderr, "\r\033[K[{}] {:3} %  {} of {}: {}", bar, percent, part_, parts_, name_);
  std::fflush(stderr);
}

}  // namespace bankshot::app::report
