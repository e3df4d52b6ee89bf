// SPDX-License-Identifier: MIT
//
// A client's socket under httplib. httplib itself restarts its timeout with every byte and does not tell that a client
// has gone. Here each request has one time limit to arrive, each answer has one to be taken, and the code that works
// for a client can ask whether it is still there.
#pragma once

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>

#include "app/serve/patience.hpp"

namespace bankshot::app::serve {

class Connection final : public httplib::Stream {
 public:
  Connection(int socket, const Patience& patience) : socket_(socket), patience_(patience) {}

  /// Waits until a request begins; returns false if none does while the server is `open`.
  bool begins(const std::function<bool()>& open);
  /// Returns whether nobody waits for the answer. A client that closed its own side counts as gone, as with other
  /// servers.
  bool gone() const;
  /// Returns whether the request took too long or was too large; nothing more is read from it.
  bool cut() const { return cut_; }
  void cut_off() { cut_ = true; }
  /// Closes the sending side. If the client was cut off, what it still sends is read first: closing a socket with
  /// unread bytes would discard the last answer.
  void part();

  using Time = std::chrono::steady_clock::time_point;
  /// Returns when the request began that the client has not finished, or the wait for one; a time without ticks while
  /// the client is served. Any thread may ask.
  Time waited_for() const { return waited_for_; }
  /// Ends the wait for a client. Any thread may call it while the socket is open.
  void give_up() const;

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  socket_t socket() const override { return socket_; }
  void get_remote_ip_and_port(std::string&, int&) const override {}  // nobody here asks for it
  void get_local_ip_and_port(std::string&, int&) const override {}

 private:
  /// Waits for the event, and subtracts the time from `left`.
  bool ready(short event, Waiting& left) const;

  const int socket_;
  const Patience patience_;
  Waiting request_left_{}, answer_left_{};
  Time begun_{};
  std::atomic<Time> waited_for_{Time{}};
  std::size_t bytes_left_ = 0;  ///< of the request
  bool cut_ = false;
  std::array<char, 4096> read_{};
  std::size_t from_ = 0, to_ = 0;  ///< range of `read_` that was received and not yet handed out
};

}  // namespace bankshot::app::serve
