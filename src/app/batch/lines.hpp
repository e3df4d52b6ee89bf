// SPDX-License-Identifier: MIT
//
// The lines of a file, of standard input ("-") or of a gzip file (*.gz), a chunk at a time. Where a
// chunk ends depends on the lines alone, so the same input is cut the same way each time.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bankshot::app::batch {

/// How much of the input lies behind, with a checksum of it.
struct ReadMark {
  long lines = 0, bytes = 0;
  std::uint32_t crc = 0;
  bool operator==(const ReadMark&) const = default;
};

/// CRC-32 that goes on from `before`.
std::uint32_t checksum(std::uint32_t before, const char* data, std::size_t size);

/// Part number `k`, from 0, of `n` of nearly as many bytes each.
struct Part {
  long k = 0, n = 1;
  bool operator==(const Part&) const = default;
};

/// A few lines without their line breaks.
struct Lines {
  struct Line {
    std::size_t begin, size;
    bool too_long;  ///< only its beginning was kept
  };
  std::string text;
  std::vector<Line> lines;
  ReadMark after;     ///< behind the last of them
  double share = -1;  ///< of the input that is read; -1 where its length is not known
  /// Of line i in the whole input, from 1.
  long number(std::size_t i) const { return after.lines - static_cast<long>(lines.size() - i) + 1; }
  std::string_view line(std::size_t i) const { return std::string_view(text).substr(lines[i].begin, lines[i].size); }
};

class LineReader {
 public:
  static constexpr std::size_t lines_a_chunk = 64;       ///< a kill loses the chunks under way
  static constexpr std::size_t bytes_a_chunk = 1 << 20;  ///< long lines make shorter chunks
  static constexpr std::size_t longest_line = 4 << 20;   ///< bytes; more is no puzzle, and memory is to stay flat

  /// `whole_chunks`: wait for them also where the input comes in slowly. Else what is there is handed
  /// out at once, so that a program can send a puzzle and wait for its answer.
  LineReader(const std::string& path, bool whole_chunks);
  /// The lines that begin in this part of the file, which is no stream; what stands before them counts as read.
  LineReader(const std::string& path, bool whole_chunks, const Part& part);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// False at the end of the input, and once the program is interrupted. Throws FileError.
  bool next(Lines& out);
  /// Reads up to `mark`; false when what was read is not what was read then.
  bool skip(const ReadMark& mark);
  /// What is known beforehand, to tell one input from another: length and checksum of its end; empty
  /// for a stream.
  std::string identity() const;
  bool same_file(int descriptor) const;
  double share() const;                             ///< of the input that is read; -1 where its length is not known
  const ReadMark& begun() const { return begun_; }  ///< what stands before the first line
  const ReadMark& mark() const { return mark_; }    ///< what was read

 private:
  void find(const Part& part);
  bool add_line(Lines& out);
  bool fill();
  bool more_is_there() const;
  bool wait_for_input() const;

  std::string name_;
  int fd_ = -1;
  gzFile gz_ = nullptr;
  long size_ = -1;  ///< of a regular file
  bool whole_chunks_;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;
  ReadMark mark_, begun_;
  long until_ = std::numeric_limits<long>::max();  ///< bytes: no line that begins behind is read
};

}  // namespace bankshot::app::batch
