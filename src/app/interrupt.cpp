// SPDX-License-Identifier: MIT
#include "app/interrupt.hpp"

#include <csignal>

#include <atomic>

namespace bankshot::app {
namespace {

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void note_signal(int signal) { noted.store(signal, std::memory_order_relaxed); }

}  // namespace

Interrupts::Interrupts() {
  struct sigaction once {};
  once.sa_handler = note_signal;
  once.sa_flags = static_cast<int>(SA_RESETHAND);  // a signal wakes waiting reads, and a second one ends the program
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  // an ignored SIGHUP means that nohup started the program
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &once, nullptr);
  sigaction(SIGINT, &once, nullptr);
  sigaction(SIGTERM, &once, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

int interrupted() { return noted.load(std::memory_order_relaxed); }

}  // namespace bankshot::app
