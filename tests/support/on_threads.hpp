// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace bankshot::test {

/// Calls `f(i)` once for each i below `count`, on so many threads.
template <class F>
void on_threads(int threads, std::size_t count, const F& f) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> pool;
  for (int t = 0; t < threads; ++t)
    pool.emplace_back([&] {
      for (std::size_t i; (i = next++) < count;) f(i);
    });
}

}  // namespace bankshot::test
