// SPDX-License-Identifier: MIT
//
// Which requests are worked on: at most one for each core, a few that wait, and no more; each has a time limit, and
// makes room for a newer one of the same page.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
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
  /// Ends all work, and waits until it is done.
  ~Desk();

  /// One request; done with its end.
  class Work {
   public:
    explicit Work(Desk& desk) : desk_(desk) {}
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    ~Work() { desk_.leave(*this); }

    std::atomic<bool> stop{false}, late{false};

   private:
    friend class Desk;
    Desk& desk_;
    std::string page_;
    std::chrono::steady_clock::time_point until_;
  };
  /// Null where too many wait already. `page`: older work of the same one is stopped; empty: of no page.
  std::unique_ptr<Work> begin(const std::string& page);

  double seconds() const { return seconds_; }
  void stop_all();

 private:
  void leave(Work& work);
  void watch();

  const int at_once_, most_waiting_;
  const double seconds_;
  std::mutex mutex_;
  std::condition_variable free_, ended_;
  int working_ = 0, waiting_ = 0;
  bool closed_ = false;
  std::list<Work*> all_;
  std::thread watcher_;
};

}  // namespace bankshot::app::serve
