// SPDX-License-Identifier: MIT
//
// A bar on standard error while a long command works; nothing when that is no terminal.
#pragma once

#include <string>

namespace bankshot::app::report {

class Progress {
 public:
  /// `parts`: how many parts the work has, each counted as long as the others.
  explicit Progress(int parts);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< takes the bar away

  /// Begins the next part, of so many steps.
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
