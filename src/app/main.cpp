// SPDX-License-Identifier: MIT
//
// The program: reads the command line, runs one command, turns every failure into one line on
// standard error and an exit code.
#include <iostream>
#include <map>

#include "app/commands.hpp"
#include "app/files.hpp"

int main(int argc, char** argv) {
  using namespace bankshot::app;
  CLI::App app("bankshot: finds the launch speed and angle for a shot in cue sports", "bankshot");
  app.set_version_flag("--version", "bankshot " BANKSHOT_VERSION);
  app.require_subcommand(1);
  const std::map<std::string, Run> commands{{"solve", add_solve(app)}, {"simulate", add_simulate(app)}};
  try {
    app.parse(argc, argv);
    return commands.at(app.get_subcommands().front()->get_name())();
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    std::cerr << "bankshot: " << e.what() << "; see bankshot --help\n";
  } catch (const std::exception& e) {
    std::cerr << "bankshot: " << e.what() << '\n';
  }
  return bad_input;
}
