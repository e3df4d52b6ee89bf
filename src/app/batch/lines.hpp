// SPDX-License-Identifier: MIT
//
// The lines of a file, of standard input ("-") or of a gzip file (*.gz), one chunk at a time. The end of a chunk
// depends on the lines alone, so that the same input is always cut in the same way.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bankshot::app::batch {

/// The extent of the input read so far, with its checksum.
struct ReadMark {
  long lines = 0, bytes = 0;
  std::uint32_t crc = 0;
  bool operator==(const ReadMark&) const = default;
};

/// Returns the CRC-32 continued from `before`.
std::uint32_t checksum(std::uint32_t before, const char* data, std::size_t size);

/// Part number `k`, counted from 0, of `n` parts with nearly equal numbers of bytes.
struct Part {
  long k = 0, n = 1;
  bool operator==(const Part&) const = default;
};

/// A chunk of lines without their line breaks.
struct Lines {
  struct Line {
    std::size_t begin, size;
    bool too_long;  ///< only its beginning was kept
  };
  std::string text;
  std::vector<Line> lines;
  ReadMark after;     ///< position after the last of these lines
  double share = -1;  ///< share of the input read so far; -1 if its length is unknown
  /// Returns the number of line i in the whole input, counted from 1.
  long number(std::size_t i) const { return after.lines - static_cast<long>(lines.size() - i) + 1; }
  std::string_view line(std::size_t i) const { return std::string_view(text).substr(lines[i].begin, lines[i].size); }
};

class LineReader {
 public:
  static constexpr std::size_t lines_a_chunk = 64;       ///< a kill loses the chunks in progress
  static constexpr std::size_t bytes_a_chunk = 1 << 20;  ///< bytes; long lines make shorter chunks
  /// Bytes; no puzzle is longer, and the limit keeps memory bounded.
  static constexpr std::size_t longest_line = 4 << 20;

  /// `whole_chunks`: wait for full chunks even if the input comes in slowly. Otherwise the lines at hand are returned
  /// at once, so that a program can send a puzzle and wait for its answer.
  LineReader(const std::string& path, bool whole_chunks);
  /// Reads the lines that begin in this part of the file; a stream has no parts. The lines before the part count as
  /// read.
  LineReader(const std::string& path, bool whole_chunks, const Part& part);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Reads the next chunk. Returns false at the end of the input and once the program is interrupted. Throws FileError.
  bool next(Lines& out);
  /// Reads up to `mark`; false if the bytes differ from those read when the mark was made.
  bool skip(const ReadMark& mark);
  /// Returns what tells one input from another before it is read: its length and the checksum of its end. Empty for a
  /// stream.
  std::string identity() const;
  bool same_file(int descriptor) const;
  double share() const;                             ///< share of the input read so far; -1 if its length is unknown
  const ReadMark& begun() const { return begun_; }  ///< position of the first line
  const ReadMark& mark() const { return mark_; }    ///< how much was read

 private:
  void find(const Part& part);
  bool add_line(Lines& out);
  bool fill();
  bool more_is_there() const;
  bool wait_for_input() const;

  std::string name_;
  int fd_ = -1;
  gzFile gz_ = nullptr;
  long size_ = -1;  ///< bytes of a regular file; -1 for a stream
  bool whole_chunks_;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;
  ReadMark mark_, begun_;
  long until_ = std::numeric_limits<long>::max();  ///< bytes; no line that begins after this offset is read
};

}  // namespace bankshot::app::batch
