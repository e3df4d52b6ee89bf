// SPDX-License-Identifier: MIT
//
// How long a client is waited for, altogether: a byte now and then does not keep a connection.
#pragma once

#include <chrono>

namespace bankshot::app::serve {

using Waiting = std::chrono::duration<double>;  // s

struct Patience {
  Waiting idle{2};      ///< for another request: a thread that waits for one serves no other
  Waiting request{10};  ///< for all bytes of a request
  Waiting answer{30};   ///< until it has taken all bytes of an answer
};

}  // namespace bankshot::app::serve
