// SPDX-License-Identifier: MIT
//
// Misbehaving clients at one server: each must get an answer or a clean close, other clients must be served, and the
// memory must not grow.
//   rude --requests 4000 --clients 8 --seed 1
// Prints how many clients of each kind were answered, closed or left hanging. Exit 1 if one was left hanging, if an
// honest request in between was not answered with 200, or if the memory grew by more than --grows MB in the second
// half. Some growth is normal, because each of the server's hundred threads keeps some of the memory it freed.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <fstream>
#include <iostream>
#include <thread>
#include <vector>

#include "app/serve/server.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/caller.hpp"

using namespace bankshot;
using test::Caller;

namespace {

const std::string honest = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"pocket": "top-right"}})";
/// This search takes far longer than its time limit.
const std::string endless = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"pocket": "any"},
  "cushions": {"min": 5, "max": 9}, "budget": {"simulations": 1000000000}})";
const std::string close_after = "Connection: close\r\n";

std::string random_bytes(Random& random, int most) {
  std::string bytes;
  for (int k = random.integer(0, most); k > 0; --k) bytes += static_cast<char>(random.integer(0, 255));
  return bytes;
}

/// Changes some letters of the text.
std::string misspelt(Random& random, std::string text) {
  for (int k = random.integer(1, 5); k > 0; --k)
    text[static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1))] =
        static_cast<char>(random.integer(1, 127));
  return text;
}

/// A kind of client, and the bytes it sends; `leaves`: it does not wait for an answer.
struct Kind {
  const char* name;
  bool leaves;
  std::string (*bytes)(Random&, int port);
};

const std::array<Kind, 9> kinds{{
    {"random bytes", false, [](Random& r, int) { return random_bytes(r, 2000); }},
    {"a malformed body", false,
     [](Random& r, int port) { return test::post(port, "/api/solve", misspelt(r, honest), close_after); }},
    {"a malformed head", false,
     [](Random& r, int port) { return misspelt(r, test::post(port, "/api/solve", honest, close_after)); }},
    {"an oversized body", false,
     [](Random&, int port) { return test::post(port, "/api/solve", std::string((1 << 20) + 1, ' '), close_after); }},
    {"many headers", false,
     [](Random&, int port) {
       std::string many = close_after;
       for (int k = 0; k < 100000; ++k) many += "X: yyyyyyyyyyyyyyyyyyyyyyyyyy\r\n";
       return test::post(port, "/api/solve", honest, many);
     }},
    {"a wrong Host", false,
     [](Random&, int port) { return test::post(port, "/api/solve", honest, "Host: evil.example\r\n" + close_after); }},
    {"a wrong Origin", false,
     [](Random&, int port) {
       return test::post(port, "/api/solve", honest, "Origin: http://evil.example\r\n" + close_after);
     }},
    {"gone in mid-solve", true, [](Random&, int port) { return test::post(port, "/api/solve?all", endless); }},
    {"half of a request", false,
     [](Random& r, int port) {
       const std::string whole = test::post(port, "/api/solve", honest, close_after);
       return whole.substr(0, static_cast<std::size_t>(r.integer(1, static_cast<int>(whole.size()) - 1)));
     }},
}};

struct Count {
  std::atomic<int> answered{0}, closed{0}, left{0}, hanging{0};
};

/// Visits the server once and counts how it ended: with a status, or only with a close.
void visit(const Kind& kind, Random& random, int port, Count& count) {
  const Caller caller(port);
  caller.says(kind.bytes(random, port));
  if (kind.leaves) return void(++count.left);
  if (random.integer(0, 1) == 1) caller.says_no_more();
  const auto heard = caller.hears();
  ++(!heard ? count.hanging : heard->starts_with("HTTP/1.1 ") ? count.answered : count.closed);
}

/// Repeats an honest request while the server is busy.
bool served(int port) {
  for (int k = 0; k < 1000; ++k) {
    const Caller caller(port);
    caller.says(test::post(port, "/api/solve", honest, close_after));
    const std::string heard = caller.hears().value_or("");
    if (heard.starts_with("HTTP/1.1 200")) return true;
    if (!heard.starts_with("HTTP/1.1 503")) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

double memory_in_use() {
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Clients as none should be");
  int requests = 4000, clients = 8;
  std::uint64_t seed = 1;
  double grows = 16;
  app.add_option("--requests", requests)->capture_default_str();
  app.add_option("--clients", clients)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--grows", grows, "MB that the memory may grow by; a sanitizer keeps what was freed")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  app::serve::ServerOptions options{.port = 0};
  options.patience.request = std::chrono::milliseconds(500);
  app::serve::Server server(options);
  std::thread serving([&] { server.run(); });
  std::array<Count, kinds.size()> counts;
  std::atomic<int> next{0}, unserved{0};
  std::atomic<double> early{0};
  const auto visits = [&] {
    for (int i = next++; i < requests; i = next++) {
      Random random(seed * 1000003 + static_cast<std::uint64_t>(i));
      const auto k = static_cast<std::size_t>(i) % kinds.size();
      visit(kinds[k], random, server.port(), counts[k]);
      if (i % 50 == 0) unserved += !served(server.port());
      if (i == requests / 2) early = memory_in_use();
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < clients; ++i) threads.emplace_back(visits);
  for (std::thread& t : threads) t.join();
  unserved += !served(server.port());
  const double late = memory_in_use();
  server.stop();
  serving.join();
  int hanging = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Count& c = counts[k];
    std::cout << fmt::format("{:18} {:5} answered, {:5} closed, {:5} left, {:5} hanging\n", kinds[k].name,
                             c.answered.load(), c.closed.load(), c.left.load(), c.hanging.load());
    hanging += c.hanging;
  }
  const bool flat = late - early < grows;
  std::cout << fmt::format(
      "{} requests, seed {}: {} left hanging, {} honest ones not served; memory {:.1f} MB after "
      "half, {:.1f} MB at the end\n",
      requests, seed, hanging, unserved.load(), early.load(), late);
  return hanging > 0 || unserved > 0 || !flat ? 1 : 0;
}
