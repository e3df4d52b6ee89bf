// SPDX-License-Identifier: MIT
#include "app/serve/listener.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace bankshot::app::serve {
namespace {

/// The treatment of a connection by this thread.
enum class Welcome { served, told_to_come_back, closed };
thread_local Welcome welcome = Welcome::served;
thread_local Connection* connection_here = nullptr;

constexpr Patience at_the_door{.idle = Waiting{0.5}, .request = Waiting{0.5}, .answer = Waiting{0.5}};
/// Time in which a connection may come free for a client at the door: one that has just been opened, or answered, is
/// neither free nor waited for.
constexpr std::chrono::milliseconds for_a_place{250};

class Workers : public httplib::TaskQueue {
 public:
  Workers(Listener& listener, std::size_t connections)
      : listener_(listener), connections_(connections), pool_(connections), door_(1) {}

  void enqueue(std::function<void()> connection) override {
    const bool many = open_.fetch_add(1) >= 2 * connections_;
    const auto at_last = [this, connection = std::move(connection)] {
      connection();
      --open_;
    };
    if (many)
      meet(Welcome::closed, at_last);
    else if (served_ < connections_)
      serve(at_last);
    else
      door_.enqueue([this, at_last, until = std::chrono::steady_clock::now() + for_a_place] {
        if (finds_place(until))
          serve(at_last);
        else
          meet(Welcome::told_to_come_back, at_last);
      });
  }
  void shutdown() override {
    door_.shutdown();
    pool_.shutdown();
  }

 private:
  static void meet(Welcome how, const std::function<void()>& connection) {
    welcome = how;
    connection();
  }
  void serve(const std::function<void()>& connection) {
    ++served_;
    pool_.enqueue([this, connection] {
      meet(Welcome::served, connection);
      --served_;
    });
  }
  bool finds_place(std::chrono::steady_clock::time_point until) {
    while (served_ >= connections_ && !listener_.make_room()) {
      if (std::chrono::steady_clock::now() >= until) return false;
      std::this_thread::sleep_for(Waiting{0.002});
    }
    return true;
  }

  Listener& listener_;
  const std::size_t connections_;
  std::atomic<std::size_t> open_{0}, served_{0};
  httplib::ThreadPool pool_, door_;
};

}  // namespace

Listener::Listener(std::size_t connections, const Patience& patience) : patience_(patience) {
  new_task_queue = [this, connections] { return new Workers(*this, connections); };  // httplib deletes it
}

void Listener::let_many_wait() const { ::listen(svr_sock_, SOMAXCONN); }

Connection& Listener::here() { return *connection_here; }

bool Listener::no_room() { return welcome == Welcome::told_to_come_back; }

bool Listener::make_room() {
  const std::lock_guard lock(mutex_);
  const auto waits = [](const Connection* c) { return c->waited_for() != Connection::Time{}; };
  const auto later = [&](const Connection* a, const Connection* b) {
    return waits(a) && (!waits(b) || a->waited_for() < b->waited_for());
  };
  const auto oldest = std::ranges::min_element(open_, later);
  if (oldest == open_.end() || !waits(*oldest)) return false;
  (*oldest)->give_up();
  open_.erase(oldest);
  return true;
}

bool Listener::process_and_close_socket(socket_t socket) {
  Connection connection(socket, no_room() ? at_the_door : patience_);
  connection_here = &connection;
  if (welcome == Welcome::served) {
    const std::lock_guard lock(mutex_);
    open_.push_back(&connection);
  }
  bool more = welcome != Welcome::closed;
  for (std::size_t left = keep_alive_max_count_; more && left > 0; --left) {
    const bool last = no_room() || left == 1;
    bool closes = false;
    more = connection.begins([&] { return svr_sock_ != -1; }) && process_request(connection, last, closes, nullptr) &&
           !closes && !last && !connection.cut();
  }
  {
    const std::lock_guard lock(mutex_);
    open_.remove(&connection);
  }
  connection.part();
  return close(socket) == 0;
}

}  // namespace bankshot::app::serve
