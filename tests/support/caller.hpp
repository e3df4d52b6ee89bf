// SPDX-License-Identifier: MIT
//
// A client of `serve` for misuse: it sends any bytes, may stop in the middle of a request, and returns all that it
// receives.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <system_error>

namespace bankshot::test {

class Caller {
 public:
  /// Connects to `port`. A positive `room` sets the size of the receive buffer [bytes].
  explicit Caller(int port, int room = 0) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    if (room > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    const timeval limit{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) != 0)
      throw std::system_error(errno, std::generic_category());
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller() { close(socket_); }

  /// Sends the bytes; returns false once the server has closed the connection.
  bool says(const std::string& bytes) const {
    return send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
  }
  /// Returns true when a byte has arrived that is not read yet.
  bool is_told() const {
    char one = 0;
    return recv(socket_, &one, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
  }
  void says_no_more() const { shutdown(socket_, SHUT_WR); }
  /// Reads until the server closes the connection; returns none when it has not done so 20 s after the last byte.
  std::optional<std::string> hears() const {
    std::string back;
    char part[4096];
    ssize_t n = 0;
    while ((n = recv(socket_, part, sizeof part, 0)) > 0) back.append(part, static_cast<std::size_t>(n));
    if (n < 0 && errno == EAGAIN) return {};
    return back;
  }

 private:
  const int socket_;
};

/// Builds a request; `more` holds further headers, each with its end of line.
inline std::string post(int port, const std::string& path, const std::string& body, const std::string& more = {}) {
  const std::string host =
      more.find("Host:") == std::string::npos ? "Host: localhost:" + std::to_string(port) + "\r\n" : "";
  return "POST " + path + " HTTP/1.1\r\n" + host + more + "Content-Length: " + std::to_string(body.size()) +
         "\r\n\r\n" + body;
}

}  // namespace bankshot::test
