// SPDX-License-Identifier: MIT
//
// bankshot completion bash|zsh|fish: the script that completes the program's command lines in a shell.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/manual/options.hpp"

namespace bankshot::app::completion {
namespace {

using namespace manual;

/// Puts `text` into single quotes for a shell.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string names_of(const std::vector<const CLI::App*>& all) {
  std::string out;
  for (const CLI::App* c : all) out += (out.empty() ? "" : " ") + c->get_name();
  return out;
}

std::string bash(const CLI::App& app) {
  std::string cases, choices;
  for (const CLI::App* c : commands(app)) {
    std::string names, values;
    for (const Option& o : options(*c)) {
      const std::string words = fmt::format("{}", fmt::join(o.choices, " "));
      if (o.names.empty()) {
        values = words;
        continue;
      }
      names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(o.names, " "));
      if (!words.empty()) choices += fmt::format("    {}) values='{}' ;;\n", fmt::join(o.names, "|"), words);
    }
    cases += fmt::format("    {}) options='{}' values='{}' ;;\n", c->get_name(), names, values);
  }
  const std::string all = names_of(commands(app));
  return fmt::format(R"(# bash completion of bankshot
_bankshot() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} options='' values=''
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $before in
{}  esac
  if [[ $COMP_CWORD -eq 1 ]]; then
    options='--help --version' values='{}'
  fi
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ $values ]]; then
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _bankshot bankshot
)",
                     cases, choices, all);
}

/// Escapes an option's description for the brackets of zsh's `_arguments`.
std::string in_brackets(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh(const CLI::App& app) {
  std::string list, cases;
  for (const CLI::App* c : commands(app)) {
    list += fmt::format("    {}\n", in_quotes(c->get_name() + ":" + c->get_description()));
    std::string specs, rest = "*:file:_files";
    for (const Option& o : options(*c)) {
      if (o.names.empty() && !o.choices.empty()) rest = fmt::format("*:value:({})", fmt::join(o.choices, " "));
      for (const std::string& name : o.names) {
        std::string spec = fmt::format("{}[{}]", name, in_brackets(o.meaning));
        if (!o.choices.empty())
          spec += fmt::format(":value:({})", fmt::join(o.choices, " "));
        else if (!o.value.empty())
          spec += ":value:_files";
        specs += " \\\n        " + in_quotes(spec);
      }
    }
    cases += fmt::format("      {}) _arguments{} \\\n        {} ;;\n", c->get_name(), specs, in_quotes(rest));
  }
  return fmt::format(R"(#compdef bankshot
_bankshot() {{
  local -a commands
  commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
  else
    case $words[2] in
{}    esac
  fi
}}
_bankshot "$@"
)",
                     list, cases);
}

std::string fish(const CLI::App& app) {
  std::string out = "# fish completion of bankshot\n";
  for (const CLI::App* c : commands(app)) {
    out += fmt::format("complete -c bankshot -f -n __fish_use_subcommand -a {} -d {}\n", c->get_name(),
                       in_quotes(c->get_description()));
    for (const Option& o : options(*c)) {
      if (o.names.empty() && o.choices.empty()) continue;
      std::string line = fmt::format("complete -c bankshot -n '__fish_seen_subcommand_from {}'", c->get_name());
      for (const std::string& name : o.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!o.value.empty() && !o.names.empty()) line += " -r";
      if (!o.choices.empty()) line += " -f -a " + in_quotes(fmt::format("{}", fmt::join(o.choices, " ")));
      out += line + " -d " + in_quotes(o.meaning) + "\n";
    }
  }
  return out;
}

}  // namespace

Run add(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "Print completions for a shell");
  command->add_option("shell", *shell, "The shell")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  explain(*command, "An installed bankshot already has them in place.",
          {{"bankshot completion bash > bankshot.bash", "for ~/.bashrc to source"}}, "0 done; 2 bad usage.");
  return [shell, &app] {
    print(*shell == "bash" ? bash(app) : *shell == "zsh" ? zsh(app) : fish(app));
    return done;
  };
}

}  // namespace bankshot::app::completion
