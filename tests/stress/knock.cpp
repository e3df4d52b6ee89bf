// SPDX-License-Identifier: MIT
//
// Measures whether each of many clients of one server gets its answer, and how soon.
//   knock --requests 10000 --clients 16
// Prints the rate, the median and the 99 % time; exit 1 if any request was not answered with 200.
#include <fmt/format.h>
#include <httplib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <numeric>
#include <thread>
#include <vector>

#include "app/serve/server.hpp"
#include "bankshot/scene/json.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

int main(int argc, char** argv) {
  CLI::App app("Many clients at one server");
  int requests = 10000, clients = 16;
  bool csv = false;
  app.add_option("--requests", requests)->capture_default_str();
  app.add_option("--clients", clients)->capture_default_str();
  app.add_flag("--csv", csv);
  CLI11_PARSE(app, argc, argv);
  app::serve::Server server({.port = 0});
  std::thread serving([&] { server.run(); });
  test::Random random(1);
  std::vector<std::string> puzzles;
  for (int i = 0; i < requests; ++i)
    puzzles.push_back(write_puzzle(test::random_puzzle(random, test::Family::uniform, test::Model::spin).puzzle));
  std::vector<double> ms(puzzles.size());
  std::atomic<std::size_t> next{0};
  std::atomic<int> failed{0};
  const auto knock = [&] {
    httplib::Client client("127.0.0.1", server.port());
    client.set_keep_alive(true);
    client.set_tcp_nodelay(true);
    client.set_read_timeout(30);
    for (std::size_t i = next++; i < puzzles.size(); i = next++) {
      const auto begin = std::chrono::steady_clock::now();
      const auto reply = client.Post("/api/solve", puzzles[i], "application/json");
      ms[i] = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      failed += !reply || reply->status != 200;
    }
  };
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> threads;
  for (int i = 0; i < clients; ++i) threads.emplace_back(knock);
  for (std::thread& t : threads) t.join();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  server.stop();
  serving.join();
  std::ranges::sort(ms);
  const auto within = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  std::cout << fmt::format(
      fmt::runtime(csv ? "requests,clients,failed,a_second,median_ms,ms_99\n{},{},{},{:.0f},{:.2f},{:.2f}\n"
                       : "{} requests of {} clients, {} failed: {:.0f} a second, half within {:.2f} ms, 99 % within "
                         "{:.2f} ms\n"),
      requests, clients, failed.load(), requests / seconds, within(0.5), within(0.99));
  return failed > 0 ? 1 : 0;
}
