// SPDX-License-Identifier: MIT
//
// A server on its own port for a test, and puzzles for it.
#pragma once

#include <httplib.h>

#include <chrono>
#include <string>
#include <thread>

#include "app/serve/server.hpp"

namespace bankshot::test {

inline constexpr const char* easy = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]},
  "target": {"pocket": "top-right"}, "cushions": {"max": 2}})";
/// This search takes far longer than any test.
inline constexpr const char* endless = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]},
  "physics": {"model": "spin", "cushion": {"model": "mathavan2010"}}, "target": {"pocket": "any"},
  "cushions": {"min": 5, "max": 9}, "budget": {"simulations": 1000000000}})";

/// A server that runs until the test ends.
class Running {
 public:
  explicit Running(const app::serve::ServerOptions& options = {})
      : server_(with_any_port(options)), thread_([this] { server_.run(); }) {
    while (!client().Get("/api/tables")) std::this_thread::yield();
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running() {
    server_.stop();
    thread_.join();
  }

  httplib::Client client() const {
    httplib::Client c("127.0.0.1", server_.port());
    c.set_read_timeout(20);
    return c;
  }
  httplib::Result post(const std::string& path, const std::string& body, const httplib::Headers& headers = {}) const {
    return client().Post(path, headers, body, "application/json");
  }
  int port() const { return server_.port(); }

 private:
  static app::serve::ServerOptions with_any_port(app::serve::ServerOptions options) {
    options.port = 0;
    return options;
  }

  app::serve::Server server_;
  std::thread thread_;
};

/// Repeats a request while the server is busy, for 20 s at most; returns the last status.
inline int status_at_last(const Running& server, const std::string& body) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  int status = 503;
  while (status == 503 && std::chrono::steady_clock::now() < until) {
    const auto reply = server.post("/api/solve", body);
    status = reply ? reply->status : 503;  // too many clients, so the server closed the connection at once
  }
  return status;
}

}  // namespace bankshot::test
