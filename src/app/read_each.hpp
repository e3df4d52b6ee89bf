// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <iostream>
#include <string>
#include <vector>

#include "app/files.hpp"
#include "app/line_file.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app {

/// Returns what `read` makes of each line, without blank lines. A line that cannot be read is reported on standard
/// error, with file and line, and counted in `bad`.
template <class Read>
auto read_each(const std::string& file, const Read& read, long& bad) {
  std::vector<decltype(read(std::string()))> out;
  LineFile lines(file);
  for (std::string line; lines.next(line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      out.push_back(read(line));
    } catch (const InvalidInput& e) {
      ++bad;
      std::cerr << fmt::format("{}:{}: {}{}{}\n", lines.name, lines.number, e.path, e.path.empty() ? "" : " ",
                               one_line(e.what()));
    }
  }
  return out;
}

/// Reports on standard error how many lines were left out, if any were.
inline void tell_left_out(long bad, std::size_t good) {
  if (bad > 0) std::cerr << fmt::format("bankshot: {} of {} lines were left out\n", bad, bad + static_cast<long>(good));
}

}  // namespace bankshot::app
