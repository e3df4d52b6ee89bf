// SPDX-License-Identifier: MIT
//
// bankshot man [COMMAND]: the manual page, in the language of man(7).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/manual/options.hpp"
#include "io/json/reader.hpp"

namespace bankshot::app::man {
namespace {

using namespace manual;

/// Escapes `text` so that roff prints it unchanged.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '-') out += '\\';
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    out += c;
    if (c == '\\') out += 'e', out.erase(out.size() - 2, 1);
  }
  return out;
}

std::string entry(const Option& o) {
  const std::string names = o.names.empty() ? o.place : fmt::format("{}", fmt::join(o.names, ", "));
  std::string head = "\\fB" + plain(names) + "\\fR";
  if (!o.value.empty() && !o.names.empty()) head += " \\fI" + plain(o.value) + "\\fR";
  std::string body = plain(o.meaning);
  if (!o.choices.empty()) body += fmt::format(" ({})", plain(fmt::format("{}", fmt::join(o.choices, ", "))));
  if (!o.fallback.empty()) body += fmt::format(" [{}]", plain(o.fallback));
  return ".TP\n" + head + "\n" + body + "\n";
}

/// Turns the text of explain() into the sections NOTES, EXAMPLES and EXIT STATUS.
std::string told(std::string footer) {
  const auto examples = footer.find("\n\nExamples:\n"), codes = footer.find("\n\nExit codes: ");
  if (examples == std::string::npos || codes == std::string::npos) return "";
  const auto verbatim = [](const std::string& text) { return ".nf\n" + plain(text) + "\n.fi\n"; };
  constexpr std::size_t examples_word = 12, codes_word = 14;  // lengths of the two headings searched for
  return ".SH NOTES\n" + verbatim(footer.substr(0, examples)) + ".SH EXAMPLES\n" +
         verbatim(footer.substr(examples + examples_word, codes - examples - examples_word)) + ".SH EXIT STATUS\n" +
         plain(footer.substr(codes + codes_word)) + "\n";
}

std::string page(const CLI::App& command, const CLI::App* parent) {
  const std::string name = parent ? parent->get_name() + "-" + command.get_name() : command.get_name();
  const std::string typed = parent ? parent->get_name() + " " + command.get_name() : command.get_name();
  std::string out =
      fmt::format(".TH {} 1 \"\" \"bankshot {}\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n\\fB{}\\fR", plain(name),
                  BANKSHOT_VERSION, plain(name), plain(command.get_description()), plain(typed));
  const std::vector<Option> all = options(command);
  for (const Option& o : all)
    if (o.names.empty()) out += " \\fI" + plain(o.place) + "\\fR";
  out += parent ? " [options]\n" : " \\fIcommand\\fR [options]\n";
  if (!parent) {
    out += ".SH COMMANDS\n";
    for (const CLI::App* c : commands(command))
      out += ".TP\n\\fB" + plain(c->get_name()) + "\\fR\n" + plain(c->get_description()) + "\n";
  }
  out += ".SH OPTIONS\n";
  for (const Option& o : all) out += entry(o);
  return out + told(command.get_footer());
}

}  // namespace

Run add(CLI::App& app) {
  struct Arguments {
    std::string wanted, folder;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("man", "Print the manual page of the program, or of a command");
  command->add_option("command", a->wanted, "Its name; without one, the program");
  command->add_option("-o,--output", a->folder, "Write the pages of the program and of all commands into this folder");
  explain(*command, "The pages are installed with the program. This command prints them in the format of man(7).",
          {{"bankshot man solve > bankshot-solve.1", "for man -l to read"}}, "0 done; 2 there is no such command.");
  return [a, &app] {
    std::map<std::string, std::string> pages{{"", page(app, nullptr)}};
    for (const CLI::App* c : commands(app)) pages[c->get_name()] = page(*c, &app);
    for (const auto& [name, text] : pages)
      if (!a->folder.empty())
        write_file(fmt::format("{}/bankshot{}{}.1", a->folder, name.empty() ? "" : "-", name), text);
    std::vector<std::string_view> names;
    for (const auto& [name, text] : pages) names.push_back(name);
    if (!pages.contains(a->wanted))
      throw FileError(quote(a->wanted) + " is no command" + known_words(a->wanted, names));
    if (a->folder.empty()) print(pages[a->wanted]);
    return done;
  };
}

}  // namespace bankshot::app::man
