// SPDX-License-Identifier: MIT
#include "app/commands.hpp"

namespace bankshot::app {

void explain(CLI::App& command, const std::string& text, const std::vector<Example>& examples,
             const std::string& exit_codes) {
  std::size_t width = 0;
  for (const Example& e : examples) width = std::max(width, e.line.size());
  constexpr std::size_t widest = 62;  // after longer lines the words stand on a line of their own
  width = std::min(width, widest);
  std::string out = text + "\n\nExamples:\n";
  for (const Example& e : examples) {
    out += "  " + e.line;
    out += e.line.size() > width ? "\n" + std::string(width + 4, ' ') : std::string(width + 2 - e.line.size(), ' ');
    out += e.what + "\n";
  }
  command.footer(out + "\nExit codes: " + exit_codes);
}

}  // namespace bankshot::app
