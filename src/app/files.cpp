// SPDX-License-Identifier: MIT
#include "app/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "app/gzip.hpp"

namespace bankshot::app {

std::string read_file(const std::string& path) {
  ByteReader in(path);
  std::string text;
  for (std::string_view piece; !(piece = in.next()).empty();) text += piece;
  return text;
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << (is_packed(path) ? gzipped(text) : text) << std::flush;
  if (!out) throw WriteError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
}

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw FileError("standard output: cannot be written");
}

void write(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  write_file(path, text);
}

void output_is_free(const std::string& csv, bool json) {
  if (csv == "-" && json) throw FileError("--csv - and --json both go to standard output; name a file for one");
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

std::string complaint(const std::string& path, const InvalidInput& error) {
  const std::string file = path == "-" ? "standard input" : path;
  if (error.line) return one_line(fmt::format("{}:{}: {}", file, error.line, error.what()));
  return one_line(fmt::format("{}: {}{}{}", file, error.path, error.path.empty() ? "" : ": ", error.what()));
}

}  // namespace bankshot::app
