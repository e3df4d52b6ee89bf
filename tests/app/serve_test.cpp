// SPDX-License-Identifier: MIT
//
// Tests the server's answers and refusals.
#include <nlohmann/json.hpp>
#include <string>

#include "app/files.hpp"
#include "app/running_server.hpp"
#include "app/serve/door.hpp"
#include "app/serve/server.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/browser.hpp"
#include "support/caller.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

using namespace bankshot;
using app::serve::Server;
using app::serve::ServerOptions;
using test::Caller;
using test::easy;
using test::endless;
using test::Running;

namespace {

nlohmann::json json_of(const httplib::Result& reply) { return nlohmann::json::parse(reply->body); }

}  // namespace

TEST_CASE("an answer is the bytes of solve --json with the same flags") {
  const Running server;
  for (const auto& [query, flags] : {std::pair{"?no-timing", "--no-timing"},
                                     {"?no-timing&all&path", "--no-timing --all --path"},
                                     {"?no-timing&budget=5", "--no-timing --budget 5"},
                                     {"?no-timing&no-robustness&first", "--no-timing --no-robustness --first"}}) {
    const auto reply = server.post(std::string("/api/solve") + query, easy);
    REQUIRE(reply);
    CHECK(reply->status == 200);
    CHECK(reply->get_header_value("Content-Type") == "application/json");
    CHECK(reply->body == test::run_program(std::string("solve --json ") + flags, easy).out);
  }
}

TEST_CASE("an answer is not packed, which takes longer than the search") {
  const Running server;
  const auto reply = server.post("/api/solve?no-timing&all&path", easy, {{"Accept-Encoding", "gzip, deflate, br"}});
  CHECK(reply->get_header_value("Content-Encoding").empty());
  CHECK(reply->body == test::run_program("solve --json --no-timing --all --path", easy).out);
}

TEST_CASE("a body is what it is, whatever it is called") {
  const Running server;
  const std::string padded = easy + std::string(20000, ' ');
  const std::string json = server.post("/api/solve?no-timing", padded)->body;
  CHECK(json.find("solved") != std::string::npos);
  for (const char* type : {"application/x-www-form-urlencoded", "text/plain"})
    CHECK(server.client().Post("/api/solve?no-timing", padded, type)->body == json);
  CHECK(server.client().Post("/api/solve", padded, "multipart/form-data; boundary=x")->status == 400);
  CHECK(server.post("/api/solve", std::string(100000, '['))->status == 400);
}

TEST_CASE("a small request for gigabytes is refused") {
  const Running server;
  const std::string slow = R"({"table": {"length": 2, "width": 1}, "physics": "ideal", "ball": {"at": [0.5, 0.5]}, )";
  const auto refused = [&](const std::string& path, const std::string& body) {
    const auto reply = server.post(path, body);
    CHECK(reply->status == 400);
    return json_of(reply).at("reason").get<std::string>();
  };
  CHECK(refused("/api/simulate?csv", slow + R"("shot": {"speed": 1e-5, "angle": 33}})").find("rows") !=
        std::string::npos);
  CHECK(refused("/api/simulate", slow + R"("shot": {"speed": 1, "angle": 33}, "until": {"cushions": 500000}})")
            .find("events") != std::string::npos);
  CHECK(refused("/api/solve?path", slow + R"("target": {"point": [1, 0.7]}, "cushions": 2, "speed": 1e-5})")
            .find("points") != std::string::npos);
}

TEST_CASE("simulate, map, tables and schema answer as their commands do") {
  const Running server;
  const std::string shot = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "shot": {"speed": 2, "angle": 40}})";
  CHECK(server.post("/api/simulate", shot)->body == test::run_program("simulate --json", shot).out);
  CHECK(server.post("/api/simulate?csv&rate=30", shot)->body ==
        test::run_program("simulate --csv - --rate 30", shot).out);
  const auto map = server.post("/api/map?grid=4,2&no-robustness", easy);
  CHECK(map->status == 200);
  CHECK(std::count(map->body.begin(), map->body.end(), '\n') == 9);
  CHECK(server.post("/api/map?grid=4,2&svg&no-robustness", easy)->body.starts_with("<svg"));
  const nlohmann::json launches = json_of(server.post("/api/launches?angle=30,40&speed=2,4&grid=8,5", easy));
  CHECK(launches.at("grid") == nlohmann::json::array({8, 5}));
  CHECK(launches.at("made").get<std::string>().size() == 40);
  CHECK(launches.at("chance").size() == 40);
  const nlohmann::json tables = json_of(server.client().Get("/api/tables"));
  CHECK(tables.at(0).at("name") == "pool-7ft");
  CHECK(tables.at(0).at("pockets").size() == 6);
  CHECK(tables.at(0).at("pockets").at(0).at("mouth").size() == 6);
  CHECK(server.client().Get("/api/schema?document=shot")->body == test::run_program("schema shot").out);
}

TEST_CASE("a puzzle is made as generate makes it, and a wish that cannot be is refused") {
  const Running server;
  const auto made = server.post("/api/generate?seed=7&target=pot&cushions=0&balls=3&no-spin&speed=1,4&number=2", "");
  REQUIRE(made->status == 200);
  const test::Run run =
      test::run_program("generate --seed 7 --count 2 --target pot --cushions 0 --balls 3 --no-spin --speed 1,4");
  CHECK(run.out.ends_with("\n" + made->body));
  for (const char* wrong :
       {"", "?seed=1&target=hole", "?seed=1&difficulty=fun", "?seed=1&balls=22", "?seed=1&speed=4,1&target=pot"})
    CHECK(server.post(std::string("/api/generate") + wrong, "")->status == 400);
}

TEST_CASE("what is wrong with a request is said, with its JSON path") {
  const Running server;
  const auto refused = [&](const std::string& path, const std::string& body) {
    const auto reply = server.post(path, body);
    REQUIRE(reply);
    CHECK(reply->status == 400);
    return json_of(reply);
  };
  CHECK(refused("/api/solve", R"({"table": "pool-9ft", "ball": {"at": [9, 9]}, "target": {"pocket": "any"}})")
            .at("path") == "/ball/at");
  CHECK(refused("/api/solve", "{\"table\": ").at("reason").get<std::string>().size() > 10);
  CHECK(refused("/api/solve?planner=nobody", easy).at("reason").get<std::string>().find("nobody") != std::string::npos);
  CHECK(refused("/api/solve?everything", easy).at("reason").get<std::string>().find("everything") != std::string::npos);
  CHECK(refused("/api/solve?budget=few", easy).at("reason").get<std::string>().find("few") != std::string::npos);
  CHECK(refused("/api/solve?all&first", easy).at("path").get<std::string>().empty());
  CHECK(refused("/api/map?grid=0,2", easy).at("path").get<std::string>().empty());
  CHECK(refused("/api/launches?speed=1,2", easy).at("reason").get<std::string>().find("--angle") != std::string::npos);
  CHECK(refused("/api/launches?angle=40,30&speed=1,2", easy).at("reason").get<std::string>().find("--angle") !=
        std::string::npos);
  CHECK(refused("/api/launches?angle=30,40&speed=2,2", easy).at("reason").get<std::string>().find("--speed") !=
        std::string::npos);
  CHECK(refused("/api/launches?angle=30,30.000001&speed=1,2", easy).at("path") == "/noise");
  CHECK(refused("/api/map?budget=-5", easy).at("reason").get<std::string>().find("-5") != std::string::npos);
  CHECK(refused("/api/solve?help", easy).at("reason").get<std::string>().find("help") != std::string::npos);
  CHECK(refused("/api/simulate", easy).at("path") == "/shot");
}

TEST_CASE("pages and names from elsewhere are refused") {
  const Running server;
  const std::string here = "127.0.0.1:" + std::to_string(server.port());
  CHECK(server.post("/api/solve", easy, {{"Origin", "http://" + here}})->status == 200);
  CHECK(server.post("/api/solve", easy, {{"Origin", "http://evil.example"}})->status == 403);
  CHECK(server.post("/api/solve", easy, {{"Origin", "null"}})->status == 403);
  CHECK(server.post("/api/solve", easy, {{"Host", "evil.example:" + std::to_string(server.port())}})->status == 403);
  const app::serve::Door door("127.0.0.1", {}, 8080);
  CHECK(door.refuses("localhost:8080", "").empty());
  CHECK(door.refuses("[::1]:8080", "http://[::1]:8080").empty());
  CHECK(!door.refuses("localhost:8081", "").empty());
  CHECK(!door.refuses("localhost:8080", "http://127.0.0.1:8080").empty());
  CHECK(!door.refuses("", "").empty());
  const app::serve::Door open("0.0.0.0", {"table.local"}, 80);
  CHECK(open.refuses("table.local", "http://table.local").empty());
  CHECK(!open.refuses("rebound.example", "http://rebound.example").empty());
}

TEST_CASE("a search ends at its time limit, and says so") {
  ServerOptions options;
  options.time_limit = 0.1;
  const Running server(options);
  const nlohmann::json answer = json_of(server.post("/api/solve?all&no-robustness", endless));
  CHECK(answer.at("message").get<std::string>().find("the time limit of 0.1 s was over") != std::string::npos);
  CHECK((answer.at("status") == "budget" || answer.at("status") == "solved"));
  CHECK(server.post("/api/map?grid=9,9&no-robustness", endless)->status == 503);
}

TEST_CASE("what no server needs to understand is refused, and the next request is answered") {
  ServerOptions options;
  options.time_limit = 0.2;
  const Running server(options);
  for (const int size : {(1 << 20) + 1, 3 << 20, 9 << 20}) {
    CAPTURE(size);
    const auto reply = server.post("/api/solve", std::string(static_cast<std::size_t>(size), ' '));
    REQUIRE(reply);
    CHECK(reply->status == 413);
  }
  CHECK(json_of(server.client().Get("/etc/passwd")).at("reason").get<std::string>().find("/api/solve") !=
        std::string::npos);
  CHECK(server.client().Get("/../../etc/passwd")->status == 404);
  const std::uint64_t seed = 17;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    std::string bytes = i % 2 ? "POST /api/solve HTTP/1.1\r\nHost: localhost\r\n" : "";
    for (int k = random.integer(0, 300); k > 0; --k) bytes += static_cast<char>(random.integer(0, 255));
    Caller(server.port()).says(bytes);
  }
  CHECK(server.post("/api/solve", easy)->status == 200);
}

TEST_CASE("the page comes with its files and lets nothing else in") {
  const Running server;
  const auto page = server.client().Get("/");
  CHECK(page->status == 200);
  CHECK(page->get_header_value("Content-Type").starts_with("text/html"));
  CHECK(page->get_header_value("Content-Security-Policy").find("default-src 'none'") != std::string::npos);
  CHECK(page->get_header_value("Content-Security-Policy").find("frame-ancestors 'none'") != std::string::npos);
  CHECK(page->get_header_value("X-Content-Type-Options") == "nosniff");
  const auto framed = server.client().Get("/?embed");
  CHECK(framed->get_header_value_count("Content-Security-Policy") == 1);
  CHECK(framed->get_header_value("Content-Security-Policy").find("default-src 'none'") != std::string::npos);
  CHECK(framed->get_header_value("Content-Security-Policy").find("frame-ancestors") == std::string::npos);
  for (const char* file : {"/main.js", "/style.css", "/icon.svg"}) CHECK(server.client().Get(file)->status == 200);
  CHECK(page->body == test::read_repository_file("src/app/serve/page/index.html"));
}

TEST_CASE("the page solves its first puzzle, and one of its address, without a complaint") {
  const Running server;
  const std::string url = "http://127.0.0.1:" + std::to_string(server.port()) + "/";
  // The first page, a pocket, and a puzzle without a shot.
  for (const auto& [hash, title, shots] : {std::tuple{"", "Pot the 3 into top-right", 5},
                                           {"#table=pool-9ft", "Into top-right by bottom", 4},
                                           {"#target=point&least=0&most=0&others=1.2,0.623", "No shot", 0}}) {
    const auto browsed = test::browse(url + hash, 5);
    if (!browsed) return;
    CHECK(browsed->log.find("CONSOLE") == std::string::npos);
    CHECK(browsed->dom.find("<h2 id=\"title\">" + std::string(title)) != std::string::npos);
    std::size_t listed = 0;
    for (std::size_t at = 0; (at = browsed->dom.find("aria-current=", at)) != std::string::npos; ++at) ++listed;
    CHECK(listed == static_cast<std::size_t>(shots));
  }
}

TEST_CASE("a port that is taken is an error, and a polite kill is none") {
  const Running server;
  ServerOptions same;
  same.port = server.port();
  CHECK_THROWS_AS(Server(same), app::FileError);
  const test::Run run = test::run_shell(
      "said=$(mktemp); PROGRAM serve --port 0 > $said & pid=$!; for i in $(seq 100); do [ -s $said ] && break; "
      "sleep 0.05; done; rm $said; "
      "kill -TERM $pid; wait $pid; echo exit $?");
  CHECK(run.out.find("exit 0") != std::string::npos);
  CHECK(test::run_program("serve --port " + std::to_string(server.port())).exit == 2);
  CHECK(test::run_program("serve --port 70000").exit == 2);
}
