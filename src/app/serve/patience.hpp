// SPDX-License-Identifier: MIT
//
// Time limits on waiting for a client. Each is a total: a byte now and then does not keep a connection open.
#pragma once

#include <chrono>

namespace bankshot::app::serve {

using Waiting = std::chrono::duration<double>;  // s

struct Patience {
  Waiting idle{2};      ///< for the next request; meanwhile the thread serves no other client
  Waiting request{10};  ///< for all bytes of a request
  Waiting answer{30};   ///< until the client has taken all bytes of an answer
};

}  // namespace bankshot::app::serve
