// SPDX-License-Identifier: MIT
//
// The parts of `serve` below its answers: a client's connection and its time limits, who is let in, and the files of
// the page.
#include "app/serve/connection.hpp"
#include "app/serve/listener.hpp"
#include "app/serve/page.hpp"
#include "app/serve/patience.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "support/caller.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

using namespace bankshot;
using namespace bankshot::app::serve;
using Catch::Contains;

namespace {

constexpr Patience hurried{.idle = Waiting{0.1}, .request = Waiting{0.1}, .answer = Waiting{0.1}};

bool stays_open() { return true; }

/// A connection and its client, as two ends of a pair of sockets.
class Ends {
 public:
  explicit Ends(const Patience& patience = {}) : sockets_(pair()), connection(sockets_.server, patience) {}
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  ~Ends() {
    close(sockets_.server);
    goes();
  }

  /// Sends bytes as the client.
  bool sends(const std::string& bytes) const {
    return send(sockets_.client, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
  }
  void says(const std::string& bytes) const { REQUIRE(sends(bytes)); }
  std::string hears() const {
    std::string out;
    char part[4096];
    for (ssize_t n = 0; (n = recv(sockets_.client, part, sizeof part, MSG_DONTWAIT)) > 0;)
      out.append(part, static_cast<std::size_t>(n));
    return out;
  }
  /// Returns whether the client has heard all that there will be.
  bool hears_end() const {
    char one = 0;
    return recv(sockets_.client, &one, 1, MSG_DONTWAIT) == 0;
  }
  void goes() {
    if (sockets_.client >= 0) close(sockets_.client);
    sockets_.client = -1;
  }

 private:
  struct Pair {
    int server, client;
  };
  static Pair pair() {
    int both[2];
    REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, both) == 0);
    return {both[0], both[1]};
  }
  Pair sockets_;

 public:
  Connection connection;
};

/// Reads until the connection gives no more bytes.
std::string read_all(Connection& connection, std::size_t at_once) {
  std::string out, part(at_once, '\0');
  for (ssize_t n = 0; (n = connection.read(part.data(), at_once)) > 0;)
    out.append(part, 0, static_cast<std::size_t>(n));
  return out;
}

/// Answers that a listener gives until the test ends; `/wait` is answered once `go` is set.
class Listening {
 public:
  Listening(std::size_t connections, const Patience& patience) : listener_(connections, patience) {
    listener_.Get("/here", [](const httplib::Request&, httplib::Response& response) {
      response.set_content(
          std::string(Listener::no_room() ? "come back" : "welcome") + (Listener::here().gone() ? ", gone" : ", here"),
          "text/plain");
    });
    listener_.Get("/wait", [this](const httplib::Request&, httplib::Response& response) {
      ++waits;
      while (!go && !Listener::here().gone()) std::this_thread::yield();
      if (Listener::here().gone()) ++left;
      response.set_content(Listener::no_room() ? "done at the door" : "done inside", "text/plain");
    });
    port = listener_.bind_to_any_port("127.0.0.1");
    listener_.let_many_wait();
    thread_ = std::thread([this] { listener_.listen_after_bind(); });
    while (!listener_.is_running()) std::this_thread::yield();
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  ~Listening() {
    go = true;
    listener_.stop();
    thread_.join();
  }

  std::string body(const std::string& path) const {
    httplib::Client client("127.0.0.1", port);
    const auto reply = client.Get(path);
    return reply ? reply->body : "";
  }

  int port = 0;
  std::atomic<int> waits{0}, left{0};
  std::atomic<bool> go{false};

 private:
  Listener listener_;
  std::thread thread_;
};

std::string get(const std::string& path) { return "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n"; }

}  // namespace

TEST_CASE("a client is given longer for a request than to begin one, and longest to take an answer") {
  const Patience usual;
  CHECK(usual.idle.count() > 0);
  CHECK(usual.idle < usual.request);
  CHECK(usual.request < usual.answer);
  CHECK(Waiting(std::chrono::milliseconds(250)).count() == 0.25);
}

TEST_CASE("the bytes of a client are read as they were sent, whatever the size of a read") {
  const std::string text(10000, 'x');
  for (const std::size_t at_once : {std::size_t{1}, std::size_t{7}, std::size_t{4096}, std::size_t{100000}}) {
    INFO(at_once);
    Ends ends;
    ends.says("head" + text + "tail");
    ends.goes();
    REQUIRE(ends.connection.begins(stays_open));
    CHECK(ends.connection.is_readable());
    CHECK(read_all(ends.connection, at_once) == "head" + text + "tail");
    CHECK(!ends.connection.cut());
  }
}

TEST_CASE("a request that does not begin is not waited for, nor at a server that closes") {
  Ends silent(hurried);
  CHECK(!silent.connection.begins(stays_open));
  CHECK(!silent.connection.is_readable());
  Ends ends;
  int asked = 0;
  CHECK(!ends.connection.begins([&] { return ++asked < 3; }));
  CHECK(asked == 3);
  // Bytes that came with the last request begin the next one, although nothing more arrives.
  ends.says("two");
  REQUIRE(ends.connection.begins(stays_open));
  char one = 0;
  CHECK(ends.connection.read(&one, 1) == 1);
  CHECK(ends.connection.begins([] { return false; }));
}

TEST_CASE("a request that takes too long is cut off, and nothing more is read of it") {
  Ends ends(hurried);
  ends.says("GET");
  REQUIRE(ends.connection.begins(stays_open));
  CHECK(read_all(ends.connection, 100) == "GET");
  CHECK(ends.connection.cut());
  ends.says(" / too late");
  char more = 0;
  CHECK(ends.connection.read(&more, 1) == -1);
}

TEST_CASE("a request that is too large is cut off") {
  Ends ends;
  std::atomic<bool> heard{false};
  REQUIRE(ends.connection.begins([] { return false; }) == false);  // its limits count from here
  std::thread client([&] {
    const std::string block(1 << 16, 'x');
    for (int i = 0; i < 100 && !heard; ++i) ends.sends(block);
  });
  const std::size_t read = read_all(ends.connection, 1 << 16).size();
  CHECK(ends.connection.cut());
  CHECK(read == 1 << 21);
  heard = true;
  ends.connection.part();  // reads on, so that the client is not stuck
  client.join();
}

TEST_CASE("a client that went away is known to be gone, one that waits is not") {
  Ends ends;
  CHECK(!ends.connection.gone());
  ends.says("GET");
  CHECK(!ends.connection.gone());
  ends.goes();
  CHECK(ends.connection.gone());
}

TEST_CASE("an answer is written to its end, unless the client does not take it") {
  Ends ends(hurried);
  ends.says("x");
  REQUIRE(ends.connection.begins(stays_open));
  CHECK(ends.connection.is_writable());
  CHECK(ends.connection.write("answer", 6) == 6);
  CHECK(ends.hears() == "answer");
  const std::string block(1 << 16, 'y');
  int blocks = 0;
  constexpr int many = 10000;
  while (blocks < many && ends.connection.write(block.data(), block.size()) > 0) ++blocks;
  CHECK(blocks > 0);
  CHECK(blocks < many);  // the client takes nothing
  CHECK(!ends.connection.is_writable());
}

TEST_CASE("the sending side is closed at last, and what a client that was cut off still sends is read") {
  Ends ends(hurried);
  ends.connection.part();
  CHECK(ends.hears_end());
  Ends cut(hurried);
  cut.says("the rest of a request");
  cut.connection.cut_off();
  CHECK(cut.connection.cut());
  cut.connection.part();
  CHECK(cut.hears_end());
  CHECK(!cut.connection.is_readable());
}

TEST_CASE("as many clients are served as there are connections, and one more is told to come back") {
  Listening listening(1, {});
  const test::Caller served(listening.port);
  REQUIRE(served.says(get("/wait")));
  while (listening.waits == 0) std::this_thread::yield();
  CHECK(listening.body("/here") == "come back, here");
  listening.go = true;
  CHECK_THAT(served.hears().value(), Contains("done inside"));
}

TEST_CASE("clients that say nothing, or half of a request, keep nobody out") {
  Listening listening(2, {});
  std::vector<std::unique_ptr<test::Caller>> silent;
  for (int i = 0; i < 12; ++i) {
    silent.push_back(std::make_unique<test::Caller>(listening.port));
    if (i % 2 == 0) REQUIRE(silent.back()->says("GET /here HTTP/1.1\r\nHo"));
    CHECK(listening.body("/here") == "welcome, here");
  }
}

TEST_CASE("a handler learns that its own client has gone") {
  Listening listening(2, {});
  {
    const test::Caller caller(listening.port);
    REQUIRE(caller.says(get("/wait")));
    while (listening.waits == 0) std::this_thread::yield();
    CHECK(listening.body("/here") == "welcome, here");
  }
  while (listening.left == 0) std::this_thread::yield();
  CHECK(listening.waits == 1);
}

TEST_CASE("the page's files are those of the repository, each under its own path and with its type") {
  std::set<std::string_view> paths;
  for (const PageFile& file : page_files()) {
    INFO(file.path);
    CHECK(paths.insert(file.path).second);
    REQUIRE(file.path.starts_with('/'));
    const std::string name = file.path == "/" ? "index.html" : std::string(file.path.substr(1));
    CHECK(file.bytes == test::read_repository_file("src/app/serve/page/" + name));
    const std::string_view type = name.ends_with(".html")  ? "text/html; charset=utf-8"
                                  : name.ends_with(".css") ? "text/css"
                                  : name.ends_with(".js")  ? "text/javascript"
                                                           : "image/svg+xml";
    CHECK(file.type == type);
  }
  CHECK(paths.contains("/"));
  CHECK(paths.size() > 10);
}
