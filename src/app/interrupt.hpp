// SPDX-License-Identifier: MIT
//
// Ctrl-C, a closed terminal and SIGTERM: a long command checks for them between two pieces of work. The second signal
// ends the program at once.
#pragma once

namespace bankshot::app {

/// Notes SIGINT, SIGTERM and SIGHUP from its construction on. It also turns a closed pipe, or a file grown to its
/// limit, into a write error.
class Interrupts {
 public:
  Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
};

/// Returns the signal that asked the program to stop, or 0.
int interrupted();

}  // namespace bankshot::app
