// SPDX-License-Identifier: MIT
//
// The lines of a file, a gzip file (*.gz) or standard input ("-"), one after another and numbered from 1.
#pragma once

#include <string>

#include "app/gzip.hpp"

namespace bankshot::app {

class LineFile {
 public:
  /// Throws FileError, also if there is nothing to read (a folder).
  explicit LineFile(const std::string& path)
      : name(path == "-" ? "standard input" : path), bytes_(path), piece_(bytes_.next()) {}

  /// Reads the next line without its line break, which the last line may lack; returns false at the end.
  bool next(std::string& line);

  const std::string name;
  long number = 0;

 private:
  ByteReader bytes_;
  std::string_view piece_;  ///< bytes that were read and not yet handed out
};

}  // namespace bankshot::app
