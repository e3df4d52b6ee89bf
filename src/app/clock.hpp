// SPDX-License-Identifier: MIT
//
// The clock for measurements: processor time, so that other work on the same machine does not count.
#pragma once

#include <time.h>

namespace bankshot::app {

/// Returns the processor time of this thread in seconds.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace bankshot::app
