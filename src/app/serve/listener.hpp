// SPDX-License-Identifier: MIT
//
// Decides who is served: as many connections as there are threads. Where none is free, a new client takes the place of
// the one that has been waited for the longest, so that clients which say nothing keep nobody out. If all stay in
// service for a moment, one more thread tells others to come back, and connections beyond that are closed.
#pragma once

#include <httplib.h>

#include <cstddef>
#include <list>
#include <mutex>

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
  /// Ends the connection of the client that has been waited for the longest; returns false if all are being served.
  bool make_room();

 private:
  bool process_and_close_socket(socket_t socket) override;

  const Patience patience_;
  std::mutex mutex_;
  std::list<const Connection*> open_;
};

}  // namespace bankshot::app::serve
