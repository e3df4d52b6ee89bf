// SPDX-License-Identifier: MIT
//
// The HTTP server around the answers (service/answers.hpp): limits, refusals and the page's files.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/serve/patience.hpp"

namespace bankshot::app::serve {

struct ServerOptions {
  std::string host = "127.0.0.1";
  std::vector<std::string> names{};  ///< by which other machines call the server
  int port = 8080;                   ///< 0: any that is free
  double time_limit = 10;            ///< s, for one request
  int at_once = 0;                   ///< requests worked on at the same time; 0: one for each core
  int waiting = 64;                  ///< requests that may wait for their turn; more are told to come back
  std::size_t connections = 96;
  Patience patience{};  ///< time limits of each connection
};

class Server {
 public:
  /// Throws FileError if the port is taken or the host is not an address of this machine.
  explicit Server(const ServerOptions& options);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  int port() const;
  std::string url() const;
  /// Serves until `stop` is called from another thread.
  void run();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bankshot::app::serve
