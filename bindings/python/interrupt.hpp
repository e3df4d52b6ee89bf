// SPDX-License-Identifier: MIT
//
// Handles Ctrl-C during C++ work. Python's own handler only sets a flag, which is not checked before the work is done.
#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace bankshot::python {

/// While an object exists in the main thread, Ctrl-C sets `stop` and is passed on to Python. In other threads, and if
/// Python has no handler, the object does nothing: Python handles signals only in its main thread.
class Interrupt {
 public:
  Interrupt() {
    struct sigaction found {};
    if (gettid() != getpid() || current || sigaction(SIGINT, nullptr, &found) != 0) return;
    const bool heard = (found.sa_flags & SA_SIGINFO) || (found.sa_handler != SIG_DFL && found.sa_handler != SIG_IGN);
    if (!heard) return;
    before = found;
    struct sigaction ours = found;
    ours.sa_sigaction = heard_one;
    ours.sa_flags |= SA_SIGINFO;
    current = this;
    installed_ = sigaction(SIGINT, &ours, nullptr) == 0;
    if (!installed_) current = nullptr;
  }
  ~Interrupt() {
    if (!installed_) return;
    sigaction(SIGINT, &before, nullptr);
    current = nullptr;
  }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Raises the exception of Python's handler. If the work was stopped and the handler raised nothing, raises
  /// KeyboardInterrupt. The caller must hold the GIL.
  void raise() const {
    if (PyErr_CheckSignals() == 0) {
      if (!stop) return;
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
    throw pybind11::error_already_set();
  }

  std::atomic<bool> stop{false};

 private:
  static void heard_one(int signal, siginfo_t* info, void* context) {
    if (Interrupt* const i = current) i->stop = true;
    if (before.sa_flags & SA_SIGINFO)
      before.sa_sigaction(signal, info, context);
    else
      before.sa_handler(signal);
  }

  inline static std::atomic<Interrupt*> current{nullptr};
  inline static struct sigaction before {};
  bool installed_ = false;
};

/// Returns the result of `f(stop)`, which runs without the GIL.
template <class F>
auto interruptibly(const F& f) {
  Interrupt interrupt;
  auto result = [&] {
    const pybind11::gil_scoped_release release;
    return f(interrupt.stop);
  }();
  interrupt.raise();
  return result;
}

}  // namespace bankshot::python
