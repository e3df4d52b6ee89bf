// SPDX-License-Identifier: MIT
//
// The HTTP around the answers (api.hpp): limits, refusals and the page's files.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "app/serve/patience.hpp"

namespace bankshot::app::serve {

struct ServerOptions {
  std::string host = "127.0.0.1";
  int port = 8080;         ///< 0: any that is free
  double time_limit = 10;  ///< s, of one request
  int at_once = 0;         ///< requests that are worked on; 0: one for each core
  int waiting = 64;        ///< requests that wait for that; more are told to come back
  std::size_t connections = 96;
  Patience patience{};  ///< with each of them
};

class Server {
 public:
  /// Throws FileError where the port is taken or the host is none of this machine's.
  explicit Server(const ServerOptions& options);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  int port() const;
  std::string url() const;
  /// Until `stop` is called, from another thread.
  void run();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bankshot::app::serve
