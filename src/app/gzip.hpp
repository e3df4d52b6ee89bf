// SPDX-License-Identifier: MIT
//
// Packed files, known by their suffix .gz.
#pragma once

#include <zlib.h>

#include <string>
#include <string_view>

namespace bankshot::app {

inline bool is_packed(std::string_view path) { return path.ends_with(".gz"); }

/// A name without the suffix, for whoever asks what is inside.
inline std::string_view unpacked_name(std::string_view path) {
  if (is_packed(path)) path.remove_suffix(3);
  return path;
}

/// A gzip member of its own; the same bytes each time.
std::string gzipped(std::string_view text);

/// Files and standard input ("-") in pieces, unpacked where they are packed.
class ByteReader {
 public:
  /// Throws FileError.
  explicit ByteReader(const std::string& path);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// The next piece; empty at the end. Throws FileError.
  std::string_view next();

 private:
  [[noreturn]] void fail() const;

  std::string path_, buffer_;
  gzFile gz_;
};

}  // namespace bankshot::app
