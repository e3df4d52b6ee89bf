// SPDX-License-Identifier: MIT
//
// Runs work on many items on several threads; it can be cancelled.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace bankshot::planning {

/// Calls `work(begin, end)` for blocks of [0, count) until `stop`, on the given number of threads (0: one per core).
/// This thread is one of them and calls `between()` after each of its blocks. An exception of either is rethrown once
/// all threads are done.
template <class Work, class Between>
void in_parallel(std::size_t count, std::size_t block, int threads, const std::atomic<bool>& stop, const Work& work,
                 const Between& between) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr error;
  std::mutex of_error;
  const auto run = [&](bool own) noexcept {
    try {
      for (std::size_t i; !failed && !stop && (i = next.fetch_add(block)) < count;) {
        work(i, std::min(count, i + block));
        if (own) between();
      }
    } catch (...) {
      const std::lock_guard lock(of_error);
      if (!error) error = std::current_exception();
      failed = true;
    }
  };
  const std::size_t wanted =
      threads > 0 ? static_cast<std::size_t>(threads) : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> others;
    try {
      while (others.size() + 1 < std::min(wanted, (count + block - 1) / block)) others.emplace_back(run, false);
    } catch (const std::system_error&) {
      // The system cannot start more threads; the existing ones do the work.
    }
    run(true);
  }
  if (error) std::rethrow_exception(error);
}

/// Calls `f(i)` once for each i below `count`, on the given number of threads (0: one per core). An exception is
/// rethrown once all threads are done.
template <class F>
void for_each_index(std::size_t count, int threads, const F& f) {
  const std::atomic<bool> never{false};
  const auto one = [&](std::size_t i, std::size_t) { f(i); };
  in_parallel(count, 1, threads, never, one, [] {});
}

}  // namespace bankshot::planning
