// SPDX-License-Identifier: MIT
//
// Clients that need patience from the server, and its limits: clients that are slow, go away, come too often or send
// too much.
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "app/running_server.hpp"
#include "app/serve/desk.hpp"
#include "support/caller.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using app::serve::ServerOptions;
using test::Caller;
using test::easy;
using test::endless;
using test::Running;
using test::status_at_last;

TEST_CASE("a body that comes in pieces or packed is no larger than another") {
  const Running server;
  const std::string piece = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
  const Caller caller(server.port());
  bool open = caller.says("POST /api/solve HTTP/1.1\r\nHost: localhost:" + std::to_string(server.port()) +
                          "\r\nTransfer-Encoding: chunked\r\n\r\n");
  for (int i = 0; i < 17 && open; ++i) open = caller.says(piece);
  CHECK(caller.hears().value().find("413") != std::string::npos);
  CHECK(server.post("/api/solve", easy)->status == 200);
}

TEST_CASE("a search ends when its client goes away") {
  ServerOptions options;
  options.at_once = 1, options.waiting = 0, options.time_limit = 1000;
  const Running server(options);
  for (const char* path : {"/api/solve?all&no-robustness", "/api/map?grid=9,9&no-robustness"}) {
    CAPTURE(path);
    std::unique_ptr<Caller> caller;
    for (bool works = false; !works;) {  // repeated if a status request below had taken the one place
      caller = std::make_unique<Caller>(server.port());
      REQUIRE(caller->says(test::post(server.port(), path, endless)));
      for (int i = 0; i < 100 && !works; ++i) works = server.post("/api/solve", "{}")->status == 503;
    }
    caller.reset();
    CHECK(status_at_last(server, easy) == 200);  // the one place is free again
  }
}

TEST_CASE("who goes away while it waits makes room at the desk, too") {
  app::serve::Desk desk(1, 1, 1000);
  std::atomic<bool> gone{false};
  const auto work = desk.begin("", [] { return false; });
  auto waiting = std::async(std::launch::async, [&] { return desk.begin("", [&] { return gone.load(); }); });
  CHECK(waiting.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout);
  gone = true;
  CHECK(waiting.wait_for(std::chrono::seconds(20)) == std::future_status::ready);
  CHECK(!work->stop);
}

TEST_CASE("a client that is slow loses its connection, not the server") {
  ServerOptions options;
  options.connections = 1;
  options.patience = {.request = std::chrono::milliseconds(300), .answer = std::chrono::milliseconds(300)};
  const Running server(options);
  const std::string request = test::post(server.port(), "/api/solve", easy + std::string(100000, ' '));
  SECTION("a byte now and then: of the head") {
    const Caller caller(server.port());
    std::size_t sent = 0;
    while (sent < 10000 && caller.says(request.substr(sent % 8, 1)))
      ++sent, std::this_thread::sleep_for(std::chrono::milliseconds(2));
    CHECK(sent < 10000);
  }
  SECTION("a byte now and then: of the body") {
    std::string heard = " 503 ";
    while (heard.find(" 503 ") != std::string::npos) {  // the connection of another test client may still be open
      const Caller caller(server.port());
      std::size_t sent = 500;
      bool open = caller.says(request.substr(0, sent));
      for (; open && sent < request.size() && !caller.is_told(); ++sent) {
        open = caller.says(request.substr(sent, 1));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      CHECK(sent < request.size());
      heard = caller.hears().value();
    }
    CHECK(heard.find(" 408 ") != std::string::npos);
  }
  SECTION("it does not read its answer") {
    const std::string rolls = R"({"table": {"length": 2, "width": 1}, "physics": "ideal", "ball": {"at": [0.5, 0.5]},
      "shot": {"speed": 1, "angle": 33}, "until": {"cushions": 5000}})";
    const std::size_t whole = Running().post("/api/simulate?csv", rolls)->body.size();
    const Caller caller(server.port(), 4096);
    REQUIRE(caller.says(test::post(server.port(), "/api/simulate?csv", rolls)));
    CHECK(status_at_last(server, easy) == 200);
    CHECK(caller.hears().value().size() < whole);
  }
  CHECK(status_at_last(server, easy) == 200);
}

TEST_CASE("a newer request of the same page ends the older one, and who finds no room is told to come back") {
  ServerOptions options;
  options.at_once = 1, options.waiting = 0;
  const Running server(options);
  std::string older;
  std::thread first([&] {
    httplib::Result reply = server.post("/api/solve?all&no-robustness", endless, {{"Bankshot-Page", "a"}});
    while (reply->status == 503) reply = server.post("/api/solve?all&no-robustness", endless, {{"Bankshot-Page", "a"}});
    older = reply->body;
  });
  httplib::Result busy = server.post("/api/solve", "{}");
  while (busy->status != 503) busy = server.post("/api/solve", "{}");  // until the first request is being worked on
  CHECK(busy->get_header_value("Retry-After") == "1");
  CHECK(server.post("/api/solve", easy, {{"Bankshot-Page", "a"}})->status == 503);  // there is no place for it either
  first.join();
  CHECK(older.find("a newer request took its place") != std::string::npos);
}
