// SPDX-License-Identifier: MIT
#include "app/serve/desk.hpp"

#include <fmt/format.h>

namespace bankshot::app::serve {

using std::chrono::steady_clock;

Desk::Desk(int at_once, int waiting, double seconds)
    : at_once_(at_once),
      most_waiting_(waiting),
      longest_(seconds),
      too_long_(fmt::format("the time limit of {:g} s was over", seconds)),
      watcher_([this] { watch(); }) {}

Desk::~Desk() {
  stop_all();
  {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return all_.empty(); });
  }
  watcher_.join();
}

void Desk::stop_all() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  for (Work* work : all_) end(*work, "the server ended");
  ended_.notify_all();
}

std::unique_ptr<Desk::Work> Desk::begin(const std::string& page, std::function<bool()> gone) {
  std::unique_lock lock(mutex_);
  for (Work* older : all_)
    if (!page.empty() && older->page_ == page) end(*older, "a newer request took its place");
  if (closed_ || (working_ >= at_once_ && waiting_ == most_waiting_)) return nullptr;
  auto work = std::make_unique<Work>(*this);
  work->page_ = page;
  work->gone_ = std::move(gone);
  work->until_ = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(longest_);
  all_.push_back(work.get());
  ++waiting_;
  free_.wait(lock, [&] { return working_ < at_once_ || work->stop; });
  --waiting_;
  ++working_;
  return work;
}

void Desk::end(Work& work, const char* why) {
  work.why = why;
  work.stop = true;
  free_.notify_all();
}

void Desk::leave(Work& work) {
  const std::lock_guard lock(mutex_);
  all_.remove(&work);
  --working_;
  free_.notify_one();
  ended_.notify_all();
}

void Desk::watch() {
  constexpr std::chrono::milliseconds often{20};
  std::unique_lock lock(mutex_);
  while (!closed_) {
    ended_.wait_for(lock, often, [&] { return closed_; });
    for (Work* work : all_)
      if (work->stop)
        continue;
      else if (work->gone_())
        end(*work, "its asker went away");
      else if (steady_clock::now() > work->until_)
        end(*work, too_long_.c_str());
  }
}

}  // namespace bankshot::app::serve
