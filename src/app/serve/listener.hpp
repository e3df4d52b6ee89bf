// SPDX-License-Identifier: MIT
//
// Who is served: as many connections as there are threads; one more thread tells others to come back, and those that
// are too many even for that are closed.
#pragma once

#include <httplib.h>

#include <cstddef>

#include "app/serve/connection.hpp"

namespace bankshot::app::serve {

class Listener : public httplib::Server {
 public:
  Listener(std::size_t connections, const Patience& patience);

  /// Once it is bound. httplib lets five clients wait to be let in; a sixth would come again after a second.
  void let_many_wait() const;
  /// The connection that this thread handles a request of.
  static Connection& here();
  /// It is only told to come back.
  static bool no_room();

 private:
  bool process_and_close_socket(socket_t socket) override;

  const Patience patience_;
};

}  // namespace bankshot::app::serve
