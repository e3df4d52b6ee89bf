// SPDX-License-Identifier: MIT
//
// bankshot help COMMAND: prints what COMMAND --help prints.
#include "app/commands.hpp"
#include "app/files.hpp"
#include "io/json/reader.hpp"

namespace bankshot::app::help {

Run add(CLI::App& app) {
  auto wanted = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("help", "Describe a command");
  command->add_option("command", *wanted, "Its name; without one, all commands");
  explain(*command, "The same as COMMAND --help.", {{"bankshot help solve", "all that solve can do"}},
          "0 done; 2 there is no such command.");
  return [wanted, &app] {
    if (wanted->empty()) {
      print(app.get_formatter()->make_help(&app, app.get_name(),
                                           CLI::AppFormatMode::Normal));  // app.help() would print the help of `help`
      return done;
    }
    std::vector<std::string> names;
    const CLI::App& all = app;
    for (const CLI::App* known : all.get_subcommands({})) {
      names.push_back(known->get_name());
      if (names.back() != *wanted) continue;
      print(known->help(app.get_name()));
      return done;
    }
    const std::vector<std::string_view> words(names.begin(), names.end());
    throw FileError(quote(*wanted) + " is no command" + known_words(*wanted, words));
  };
}

}  // namespace bankshot::app::help
