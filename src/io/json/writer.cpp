// SPDX-License-Identifier: MIT
#include "io/json/writer.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <cmath>

#include "io/json/document.hpp"

namespace bankshot {
namespace {

/// Returns true for printable ASCII without the two characters that JSON escapes.
bool plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; });
}

}  // namespace

void JsonWriter::key(std::string_view k) {
  comma();
  out_ += '"';
  out_ += k;
  out_ += "\":";
}

void JsonWriter::number(double v) {
  if (!std::isfinite(v)) return null();
  comma();
  char text[32];                                                        // at most 24 characters
  out_.append(text, fmt::format_to(text, FMT_COMPILE("{}"), v + 0.0));  // -0 + 0 is 0
}

void JsonWriter::integer(long v) {
  comma();
  char text[32];
  out_.append(text, fmt::format_to(text, FMT_COMPILE("{}"), v));
}

void JsonWriter::string(std::string_view text) {
  if (!plain(text)) return raw(write_json(Json(text)));
  comma();
  out_ += '"';
  out_ += text;
  out_ += '"';
}

}  // namespace bankshot
