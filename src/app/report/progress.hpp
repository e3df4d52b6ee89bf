// SPDX-License-Identifier: MIT
//
// A bar on standard error while a long command works; nothing if that is not a terminal.
#pragma once

#include <string>

namespace bankshot::app::report {

class Progress {
 public:
  /// `parts`: number of parts of the work, all assumed to take equally long.
  explicit Progress(int parts);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< removes the bar

  /// Begins the next part, which has so many steps.
  void begin(const std::string& name, std::size_t steps);
  void step();

 private:
  void show();

  bool terminal_;
  int parts_, part_ = 0;
  std::size_t steps_ = 0, done_ = 0;
  int shown_ = -1;  ///< percent
  std::string name_;
};

}  // namespace bankshot::app::report
