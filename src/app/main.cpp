// SPDX-License-Identifier: MIT
//
// The program: reads the command line, runs one command, and turns every failure into one line on standard error and an
// exit code.
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <string_view>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/still_working.hpp"
#include "bankshot/plan/answer.hpp"
#include "io/json/reader.hpp"
#include "service/options.hpp"

namespace bankshot::app {
namespace {

/// Writes one line to standard error, and prints an `invalid` answer if JSON was asked for.
int refuse(const std::string& reason, bool json) {
  std::cerr << "bankshot: " << one_line(reason) << '\n';
  try {
    if (json) print(to_json(invalid_answer("", InvalidInput("", reason))) + "\n");
  } catch (const FileError&) {
    // Standard output itself failed, and standard error has already said so.
  }
  return bad_input;
}

/// Commands that show their progress, or wait for others.
constexpr std::string_view with_progress[] = {"batch", "report", "serve"};

/// Throws if `first` is not a command, and suggests similar names; the parser would only say that a command is missing.
void check_command(const std::string& first, const std::map<std::string, Run>& commands) {
  if (first.starts_with('-') || commands.contains(first)) return;
  std::vector<std::string_view> names;
  for (const auto& [name, run] : commands) names.push_back(name);
  throw CLI::ParseError(quote(first) + " is no command" + known_words(first, names), bad_input);
}

}  // namespace
}  // namespace bankshot::app

int main(int argc, char** argv) {
  using namespace bankshot::app;
  const bool json = std::any_of(argv, argv + argc, [](std::string_view a) { return a == "--json"; });
  CLI::App app("bankshot: finds the launch speed and angle for a shot in cue sports", "bankshot");
  app.set_version_flag("--version", "bankshot " BANKSHOT_VERSION_AND_COMMIT);
  app.require_subcommand(1);
  explain(app, "`bankshot help COMMAND` describes a command. docs/format.md has the format of puzzles.",
          {{"bankshot solve puzzle.json", "the aim and the speed, as text"},
           {"bankshot solve puzzle.json --json --all", "every shot, as JSON"},
           {"bankshot help solve", "all that solve can do"}},
          "0 done; 1 nothing solved, or some shot fails; 2 bad input or usage.");
#define BANKSHOT_ADD(name) {#name, name::add(app)},
  const std::map<std::string, Run> commands{BANKSHOT_COMMANDS(BANKSHOT_ADD)};
#undef BANKSHOT_ADD
  try {
    if (argc > 1) check_command(argv[1], commands);
    app.parse(argc, argv);
    const std::string name = app.get_subcommands().front()->get_name();
    std::optional<StillWorking> waits;
    if (isatty(STDERR_FILENO) == 1 && std::ranges::count(with_progress, name) == 0) waits.emplace(std::cerr);
    return commands.at(name)();
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    return refuse(std::string(e.what()) + "; see bankshot --help", json);
  } catch (const bankshot::service::BadOption& e) {
    return refuse(std::string(e.what()) + "; see bankshot --help", json);
  } catch (const WriteError& e) {
    return refuse(e.what(), false);
  } catch (const std::exception& e) {
    return refuse(e.what(), json);
  }
}
