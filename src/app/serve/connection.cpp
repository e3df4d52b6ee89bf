// SPDX-License-Identifier: MIT
#include "app/serve/connection.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace bankshot::app::serve {
namespace {

/// Most bytes of one request, headers included: httplib limits the length of a header but not their number. It is twice
/// the largest body, so that a client whose body is too large is usually told so.
constexpr std::size_t most_bytes = 1 << 21;

/// Returns the events that occur on the socket within `wait`, or 0.
int polled(int socket, short events, Waiting wait) {
  pollfd p{socket, events, 0};
  const int ms = static_cast<int>(std::ceil(1000 * std::max(wait.count(), 0.0)));
  while (poll(&p, 1, ms) < 0)
    if (errno != EINTR) return POLLERR;
  return p.revents;
}

}  // namespace

bool Connection::begins(const std::function<bool()>& open) {
  constexpr Waiting often{0.05};  // the server may close in the meantime
  request_left_ = patience_.request, answer_left_ = patience_.answer;
  bytes_left_ = most_bytes;
  bool here = from_ < to_;
  waited_for_ = begun_ = std::chrono::steady_clock::now();
  for (Waiting waited{0}; !here && waited < patience_.idle && open(); waited += often)
    here = polled(socket_, POLLIN, often) != 0;
  waited_for_ = Time{};
  return here;
}

void Connection::give_up() const { shutdown(socket_, SHUT_RDWR); }

bool Connection::gone() const { return polled(socket_, POLLRDHUP, Waiting{0}) != 0; }

bool Connection::is_readable() const { return from_ < to_ || polled(socket_, POLLIN, Waiting{0}) != 0; }

bool Connection::is_writable() const { return polled(socket_, POLLOUT, Waiting{0}) == POLLOUT; }

bool Connection::ready(short event, Waiting& left) const {
  const auto begin = std::chrono::steady_clock::now();
  const bool is = left.count() > 0 && polled(socket_, event, left) != 0;
  left -= std::chrono::steady_clock::now() - begin;
  return is;
}

void Connection::part() {
  shutdown(socket_, SHUT_WR);
  Waiting left{0.5};
  while (cut_ && ready(POLLIN, left) && recv(socket_, read_.data(), read_.size(), 0) > 0) continue;
}

ssize_t Connection::read(char* to, size_t size) {
  if (from_ == to_) {
    waited_for_ = begun_;
    cut_ = cut_ || bytes_left_ == 0 || !ready(POLLIN, request_left_);
    waited_for_ = Time{};
    if (cut_) return -1;
    const ssize_t n = recv(socket_, read_.data(), std::min(read_.size(), bytes_left_), 0);
    if (n <= 0) return n;
    from_ = 0, to_ = static_cast<std::size_t>(n);
    bytes_left_ -= to_;
  }
  const std::size_t n = std::min(size, to_ - from_);
  std::copy_n(read_.data() + from_, n, to);
  from_ += n;
  return static_cast<ssize_t>(n);
}

ssize_t Connection::write(const char* from, size_t size) {
  if (!ready(POLLOUT, answer_left_)) return -1;
  return send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace bankshot::app::serve
