// SPDX-License-Identifier: MIT
//
// Decides which requests are worked on: at most one for each core, while a limited number wait. Each has a time limit,
// and is stopped when its page sends a newer one or nobody waits for it any longer.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace bankshot::app::serve {

class Desk {
 public:
  Desk(int at_once, int waiting, double seconds);
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;
  /// Stops all work and waits until it has ended.
  ~Desk();

  /// One request; its destruction frees its place.
  class Work {
   public:
    explicit Work(Desk& desk) : desk_(desk) {}
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    ~Work() { desk_.leave(*this); }

    std::atomic<bool> stop{false};
    std::atomic<const char*> why{""};  ///< the reason in words, once stopped

   private:
    friend class Desk;
    Desk& desk_;
    std::function<bool()> gone_;
    std::string page_;
    std::chrono::steady_clock::time_point until_;
  };
  /// Waits for a free place. Returns null if too many wait already, and work that is already stopped if it ended before
  /// its turn. `page`: name of the client's page; older work of the same page is stopped. It may be empty. `gone`:
  /// returns whether the client has gone; it is called from another thread while the work lives.
  std::unique_ptr<Work> begin(const std::string& page, std::function<bool()> gone);
  void stop_all();

 private:
  void end(Work& work, const char* why);
  void leave(Work& work);
  void watch();

  const int at_once_, most_waiting_;
  const std::chrono::duration<double> longest_;
  const std::string too_long_;
  std::mutex mutex_;
  std::condition_variable free_, ended_;
  int working_ = 0, waiting_ = 0;
  bool closed_ = false;
  std::list<Work*> all_;
  std::thread watcher_;
};

}  // namespace bankshot::app::serve
