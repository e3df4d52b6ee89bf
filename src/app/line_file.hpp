// SPDX-License-Identifier: MIT
//
// The lines of a file, of a packed one (*.gz) or of standard input ("-"), one after another, numbered from 1.
#pragma once

#include <string>

#include "app/gzip.hpp"

namespace bankshot::app {

class LineFile {
 public:
  /// Throws FileError, also where there is nothing to read (a folder).
  explicit LineFile(const std::string& path)
      : name(path == "-" ? "standard input" : path), bytes_(path), piece_(bytes_.next()) {}

  /// Without its line break, which the last may lack; false at the end.
  bool next(std::string& line);

  const std::string name;
  long number = 0;

 private:
  ByteReader bytes_;
  std::string_view piece_;  ///< what is read and not handed out
};

}  // namespace bankshot::app
