// SPDX-License-Identifier: MIT
//
// Decides which requests are let in: only those of pages that this server gave out, and of programs that call it by its
// own name. A page from elsewhere would send its own Origin. A page that made its name point here (DNS rebinding) would
// send that name as Host.
#pragma once

#include <string>
#include <vector>

namespace bankshot::app::serve {

class Door {
 public:
  /// Takes the address at which the server listens, and the names by which others call it; "127.0.0.1" is also called
  /// "localhost".
  Door(const std::string& host, const std::vector<std::string>& names, int port);

  /// Returns why a request may not come in; empty if it may. `origin`: empty if the request has none.
  std::string refuses(const std::string& host, const std::string& origin) const;

 private:
  std::vector<std::string> names_;  ///< host:port
};

/// Returns whether only this machine reaches the address.
bool is_loopback(const std::string& host);

}  // namespace bankshot::app::serve
