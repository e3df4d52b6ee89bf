// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace bankshot::planning {

/// Calls `f(i)` once for each i below `count`, on `threads` threads.
template <class F>
void for_each_index(std::size_t count, int threads, const F& f) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    for (std::size_t i; (i = next++) < count;) f(i);
  };
  std::vector<std::jthread> pool;
  for (int k = 1; k < threads; ++k) pool.emplace_back(run);
  run();
}

}  // namespace bankshot::planning
