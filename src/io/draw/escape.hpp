// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bankshot {

/// Escapes a text for use between two tags.
inline std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

}  // namespace bankshot
