// SPDX-License-Identifier: MIT
//
// Ctrl-C, a closed terminal and a polite kill: a long command looks here between two pieces of work.
// The second signal ends the program at once.
#pragma once

namespace bankshot::app {

/// From its construction SIGINT, SIGTERM and SIGHUP are noted, and a closed pipe or a
/// file grown to its limit is a write error.
class Interrupts {
 public:
  Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
};

/// The signal that asked the program to stop; 0 while none did.
int interrupted();

}  // namespace bankshot::app
