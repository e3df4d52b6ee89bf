// SPDX-License-Identifier: MIT
//
// A client's socket under httplib, which itself waits for every byte anew and does not tell that a client has gone.
// Here a request has one time to arrive and its answer one to be taken, and whoever works for a client can ask whether
// it is still there.
#pragma once

#include <httplib.h>

#include <array>
#include <functional>

#include "app/serve/patience.hpp"

namespace bankshot::app::serve {

class Connection final : public httplib::Stream {
 public:
  Connection(int socket, const Patience& patience) : socket_(socket), patience_(patience) {}

  /// Waits until a request begins: false where none does while the server is `open`.
  bool begins(const std::function<bool()>& open);
  /// Nobody waits for the answer. Who has closed its own side is taken to be gone, as other servers do.
  bool gone() const;
  /// Its request took too long, or was longer than any that is answered: nothing more is read from it.
  bool cut() const { return cut_; }
  void cut_off() { cut_ = true; }
  /// Nothing more is sent. What is still under way from a client that was cut off is taken first: a socket that is
  /// closed over unread bytes takes back its last answer.
  void part();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  socket_t socket() const override { return socket_; }
  void get_remote_ip_and_port(std::string&, int&) const override {}  // nobody here asks for it
  void get_local_ip_and_port(std::string&, int&) const override {}

 private:
  /// Waits for it at the cost of `left`.
  bool ready(short event, Waiting& left) const;

  const int socket_;
  const Patience patience_;
  Waiting request_left_{}, answer_left_{};
  std::size_t bytes_left_ = 0;  ///< of the request
  bool cut_ = false;
  std::array<char, 4096> read_{};
  std::size_t from_ = 0, to_ = 0;  ///< what was read and is not asked for yet
};

}  // namespace bankshot::app::serve
