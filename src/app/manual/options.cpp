// SPDX-License-Identifier: MIT
#include "app/manual/options.hpp"

namespace bankshot::app::manual {
namespace {

/// Returns the words between the braces of a text like "TEXT:{pocket,stop,pass}".
std::vector<std::string> choices_of(const std::string& type) {
  const auto open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

}  // namespace

std::vector<Option> options(const CLI::App& command) {
  std::vector<Option> out;
  for (const CLI::Option* o : command.get_options()) {
    if (o->get_group().empty()) continue;
    Option option{.meaning = o->get_description(), .fallback = o->get_default_str()};
    for (const std::string& name : o->get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : o->get_lnames()) option.names.push_back("--" + name);
    if (option.names.empty()) option.place = o->get_name();
    if (o->get_items_expected_max() > 0) {
      option.choices = choices_of(o->get_type_name());
      option.value = o->get_type_name().substr(0, o->get_type_name().find(':'));
    }
    if (option.place == "command" && command.get_parent())
      for (const CLI::App* other : commands(*command.get_parent())) option.choices.push_back(other->get_name());
    out.push_back(std::move(option));
  }
  return out;
}

std::vector<const CLI::App*> commands(const CLI::App& app) { return app.get_subcommands({}); }

}  // namespace bankshot::app::manual
