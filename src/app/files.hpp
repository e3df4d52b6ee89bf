// SPDX-License-Identifier: MIT
//
// Reading and writing of files and streams, and the exit codes of commands.
#pragma once

#include <stdexcept>
#include <string>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app {

/// Exit codes, fixed by the interface.
enum Exit { done = 0, nothing_solved = 1, some_fail = 1, bad_input = 2 };

/// A file cannot be read or written; the program ends with `bad_input`.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A FileError after the answer was printed, so that nothing more belongs on standard output.
class WriteError : public FileError {
 public:
  using FileError::FileError;
};

/// Returns the whole file, or standard input for "-". A name that ends in .gz means a gzip file, here and in
/// write_file.
std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& text);
/// Prints to standard output; throws FileError if that fails.
void print(const std::string& text);
/// Writes to a file, or to standard output for "-".
void write(const std::string& path, const std::string& text);

/// Runs `write` first and prints afterwards: a closed pipe loses no file, and a file that cannot be written loses no
/// text.
template <class Write>
void print_after(const Write& write, const std::string& text) {
  try {
    write();
  } catch (const WriteError&) {
    print(text);
    throw;
  }
  print(text);
}

/// Throws FileError if both a table and JSON are asked for on standard output.
void output_is_free(const std::string& csv, bool json);

/// Returns `text` with line breaks and other control characters replaced by spaces.
std::string one_line(std::string text);

/// Returns "FILE:LINE: reason" or "FILE: /json/path: reason" as one line.
std::string complaint(const std::string& path, const InvalidInput& error);

}  // namespace bankshot::app
