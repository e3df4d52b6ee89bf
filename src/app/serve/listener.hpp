// SPDX-License-Identifier: MIT
//
// Decides who is served: as many connections as there are threads. One more thread tells others to come back, and
// connections beyond that are closed.
#pragma once

#include <httplib.h>

#include <cstddef>

#include "app/serve/connection.hpp"

namespace bankshot::app::serve {

class Listener : public httplib::Server {
 public:
  Listener(std::size_t connections, const Patience& patience);

  /// Lets many clients wait for a connection; to be called after binding. httplib lets only five wait, and a sixth
  /// would retry after a second.
  void let_many_wait() const;
  /// Returns the connection whose request this thread handles.
  static Connection& here();
  /// Returns whether this connection is only told to come back.
  static bool no_room();

 private:
  bool process_and_close_socket(socket_t socket) override;

  const Patience patience_;
};

}  // namespace bankshot::app::serve
