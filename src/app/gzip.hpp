// SPDX-License-Identifier: MIT
//
// Gzip files, known by their suffix .gz.
#pragma once

#include <zlib.h>

#include <string>
#include <string_view>

namespace bankshot::app {

inline bool is_packed(std::string_view path) { return path.ends_with(".gz"); }

/// Returns the name without the suffix .gz, for a caller who asks what kind of file is inside.
inline std::string_view unpacked_name(std::string_view path) {
  if (is_packed(path)) path.remove_suffix(3);
  return path;
}

/// Returns `text` as one complete gzip member; equal texts give equal bytes.
std::string gzipped(std::string_view text);

/// Reads a file or standard input ("-") in pieces, and unpacks it if it is a gzip file.
class ByteReader {
 public:
  /// Throws FileError.
  explicit ByteReader(const std::string& path);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Returns the next piece; empty at the end. Throws FileError.
  std::string_view next();

 private:
  [[noreturn]] void fail() const;

  std::string path_, buffer_;
  gzFile gz_;
};

}  // namespace bankshot::app
