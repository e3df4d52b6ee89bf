// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "bankshot/numbers/random.hpp"

namespace bankshot::test {

/// Draws a text of short, very long and blank lines; the last one may lack its line break.
inline std::string random_text(Random& draw, int lines) {
  std::string text;
  for (int i = 0; i < lines; ++i) {
    const int size = draw.chance(0.02) ? draw.integer(0, 500000) : draw.chance(0.3) ? 0 : draw.integer(0, 60);
    text += std::string(static_cast<std::size_t>(size), static_cast<char>(draw.integer('!', '~'))) + "\n";
  }
  if (!text.empty() && draw.chance(0.5)) text.pop_back();
  return text;
}

/// Splits a text at its line breaks, which the last line may lack.
inline std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

}  // namespace bankshot::test
