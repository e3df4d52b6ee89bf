// SPDX-License-Identifier: MIT
//
// Files and streams of the program, and how its commands end.
#pragma once

#include <stdexcept>
#include <string>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::app {

/// Exit codes, fixed by the interface.
enum Exit { done = 0, nothing_solved = 1, some_fail = 1, bad_input = 2 };

/// A file that cannot be read or written; ends the program with `bad_input`.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same after the answer was printed: nothing more belongs on standard output.
class WriteError : public FileError {
 public:
  using FileError::FileError;
};

/// The whole file, or standard input for "-". A name that ends in .gz is a packed file, here and in write_file.
std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& text);
/// To standard output; a failure to write is an error, not silence.
void print(const std::string& text);
/// To a file, or to standard output for "-".
void write(const std::string& path, const std::string& text);

/// Files first, then the text: a pipe that closes loses no file, and a file that cannot be written loses no text.
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

/// Throws FileError where a table goes to standard output and JSON was asked there as well.
void output_is_free(const std::string& csv, bool json);

/// `text` without line breaks and other control characters.
std::string one_line(std::string text);

/// "FILE:LINE: reason" or "FILE: /json/path: reason", one line.
std::string complaint(const std::string& path, const InvalidInput& error);

}  // namespace bankshot::app
