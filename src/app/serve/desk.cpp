// SPDX-License-Identifier: MIT
#include "app/serve/desk.hpp"

namespace bankshot::app::serve {

using std::chrono::steady_clock;

Desk::Desk(int at_once, int waiting, double seconds)
    : at_once_(at_once), most_waiting_(waiting), seconds_(seconds), watcher_([this] { watch(); }) {}

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
  for (Work* work : all_) work->stop = true;
  free_.notify_all();
  ended_.notify_all();
}

std::unique_ptr<Desk::Work> Desk::begin(const std::string& page) {
  std::unique_lock lock(mutex_);
  if (!page.empty())
    for (Work* older : all_)
      if (older->page_ == page) older->stop = true;
  if (closed_ || (working_ == at_once_ && waiting_ == most_waiting_)) return nullptr;
  auto work = std::make_unique<Work>(*this);
  work->page_ = page;
  work->until_ =
      steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(seconds_));
  all_.push_back(work.get());
  ++waiting_;
  free_.wait(lock, [&] { return working_ < at_once_; });
  --waiting_;
  ++working_;
  return work;
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
      if (!work->stop && steady_clock::now() > work->until_) work->late = true, work->stop = true;
  }
}

}  // namespace bankshot::app::serve
