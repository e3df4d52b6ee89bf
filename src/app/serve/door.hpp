// SPDX-License-Identifier: MIT
//
// Who may come in: only pages that this server gave out, and programs that call it by its own name. A page elsewhere
// would send its own Origin; one that made its name point here (DNS rebinding) would send that name as Host.
#pragma once

#include <string>
#include <vector>

namespace bankshot::app::serve {

class Door {
 public:
  /// Where it listens: "127.0.0.1" is called "localhost" as well.
  Door(const std::string& host, int port);

  /// Why a request may not come in; empty where it may. `origin`: empty where it has none.
  std::string refuses(const std::string& host, const std::string& origin) const;

 private:
  std::vector<std::string> names_;  ///< host:port
};

/// Only this machine reaches it.
bool is_loopback(const std::string& host);

}  // namespace bankshot::app::serve
