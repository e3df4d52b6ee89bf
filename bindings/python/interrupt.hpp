// SPDX-License-Identifier: MIT
//
// Ctrl-C while C++ works. Python's own handler only notes that it came; nobody looks before the work is done.
#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace bankshot::python {

/// While one lives in the main thread, Ctrl-C sets `stop`, and is told to Python as ever. Elsewhere, and where Python
/// does not listen, it does nothing: Python hears signals in its main thread alone.
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

  /// Raises what Python's handler raises; KeyboardInterrupt where the work was ended and that raised nothing. With the
  /// GIL.
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

/// What `f(stop)` gives, worked out without the GIL.
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
