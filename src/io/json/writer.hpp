// SPDX-License-Identifier: MIT
//
// Writes JSON text from left to right, without a tree: for a million answers the tree would cost more
// than the search. Numbers are written as in document.hpp. Private to the writers.
#pragma once

#include <string>
#include <string_view>

namespace bankshot {

class JsonWriter {
 public:
  JsonWriter() { out_.reserve(usual); }
  void open(char bracket) { comma(), out_ += bracket; }
  void close(char bracket) { out_ += bracket; }
  /// Writes a key that needs no escapes; its value must follow.
  void key(std::string_view k);
  /// Writes a key that may need escapes.
  void name(std::string_view text) { string(text), out_ += ':'; }
  void number(double v);  ///< null if it is not finite
  void boolean(std::string_view k, bool v) { key(k), raw(v ? "true" : "false"); }
  void integer(long v);
  void string(std::string_view text);
  void null() { raw("null"); }
  void raw(std::string_view json) { comma(), out_ += json; }
  std::string take() { return std::move(out_); }

  void number(std::string_view k, double v) { key(k), number(v); }
  void integer(std::string_view k, long v) { key(k), integer(v); }
  void string(std::string_view k, std::string_view text) { key(k), string(text); }

 private:
  static constexpr std::size_t usual = 1024;  ///< bytes of an answer with one shot, margin and success

  /// Writes a comma between two values of a list or two members of an object.
  void comma() {
    if (!out_.empty() && std::string_view("{[:").find(out_.back()) == std::string_view::npos) out_ += ',';
  }
  std::string out_;
};

}  // namespace bankshot
