// SPDX-License-Identifier: MIT
//
// One line for who waits: a command that takes longer than two seconds says so on a terminal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <thread>

namespace bankshot::app {

class StillWorking {
 public:
  /// Writes the line unless this ends before.
  explicit StillWorking(std::ostream& to, std::chrono::milliseconds after = std::chrono::seconds(2))
      : thread_([this, &to, after](const std::stop_token& done) {
          std::unique_lock lock(mutex_);
          if (!ends_.wait_for(lock, done, after, [&] { return done.stop_requested(); }))
            to << "bankshot: still working; Ctrl-C ends it\n" << std::flush;
        }) {}

 private:
  std::mutex mutex_{};
  std::condition_variable_any ends_{};
  std::jthread thread_;  ///< the last member: it ends first
};

}  // namespace bankshot::app
