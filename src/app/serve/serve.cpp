// SPDX-License-Identifier: MIT
//
// bankshot serve: the table in a browser, and an interface for programs.
#include <fmt/format.h>
#include <spawn.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/interrupt.hpp"
#include "app/serve/door.hpp"
#include "app/serve/server.hpp"
#include "service/options.hpp"

namespace bankshot::app::serve {
namespace {

struct Arguments {
  ServerOptions server;
  bool open = false;
};

void open_browser(std::string url) {
  std::string program = "xdg-open";
  char* const words[] = {program.data(), url.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) != 0)
    std::cerr << "bankshot: no browser was found; open " << url << '\n';
}

int run(const Arguments& a) {
  if (!is_loopback(a.server.host) && a.server.names.empty())
    throw service::BadOption("--host " + a.server.host +
                             ": other machines need a name for this server; give it with --allow-host NAME");
  const Interrupts interrupts;
  Server server(a.server);
  print(fmt::format("{}\nCtrl-C ends it.\n", server.url()));
  std::cout << std::flush;
  if (!is_loopback(a.server.host))
    std::cerr << "bankshot: anyone who reaches " << a.server.host << " may use this server\n";
  std::thread waits([&] {
    constexpr std::chrono::milliseconds often{50};
    while (interrupted() == 0) std::this_thread::sleep_for(often);
    server.stop();
  });
  if (a.open) open_browser(server.url());
  server.run();
  waits.join();
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("serve", "Show the table in a browser, and answer over HTTP");
  command->add_option("--host", a->server.host, "Listen at this address; any but loopback lets other machines in")
      ->capture_default_str();
  command->add_option("--allow-host", a->server.names, "A name or address by which other machines call this server")
      ->allow_extra_args(false);
  command->add_option("--port", a->server.port, "Listen at this port; 0 takes any free one")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  command->add_option("--time-limit", a->server.time_limit, "Seconds a request may take")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 3600.0));
  command->add_flag("--open", a->open, "Open the page in a browser");
  explain(
      *command,
      "POST a puzzle to /api/solve, /api/map?grid=40,20 (from where can it be made?) or\n"
      "/api/launches?angle=30,40&speed=2,4 (by which launches?). POST a shot to /api/simulate, and nothing to\n"
      "/api/generate?seed=1&target=pot, which makes a puzzle. GET /api/tables and\n"
      "/api/schema?document=puzzle. Flags are query parameters of the same names (?all&path&budget=500). The answer\n"
      "to /api/solve has the bytes of `bankshot solve --json` with the same flags. A faulty request is answered with\n"
      "400 and {\"path\", \"reason\"}. A search that exceeds the time limit ends with what it has; one whose client "
      "has\n"
      "gone ends too. 503 and Retry-After ask the client to come back. A body has at most 1 MB, and a request may\n"
      "take 10 s to arrive. A request with the header Bankshot-Page ends older ones with the same value. Pages from\n"
      "other origins are refused.",
      {{"bankshot serve --open", "the page"},
       {"bankshot serve --host 0.0.0.0 --allow-host table.local", "for phones in this house"},
       {"curl --json @puzzle.json 'localhost:8080/api/solve?all'", "every shot, from another program"}},
      "0 ended by Ctrl-C or a polite kill; 2 bad usage, or the port is taken.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::serve
