// SPDX-License-Identifier: MIT
//
// The destination of answers: a file, standard output ("-") or a gzip file (*.gz). A gzip file is a sequence of
// members, one for each piece written, as the format allows. So it can be cut between any two members and continued.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace bankshot::app::batch {

class Output {
 public:
  /// Opens the file without changing it yet. Throws WriteError.
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool regular() const { return regular_; }  ///< a regular file, which can be cut and continued
  bool gzip() const { return gzip_; }
  int descriptor() const { return fd_; }
  const std::string& name() const { return name_; }

  long size() const;  ///< current size of the file
  /// Keeps the first `size` bytes, whose checksum is `crc`, and continues after them.
  void cut(long size, std::uint32_t crc = 0);
  /// Drops an incomplete piece; ignores failures, as the file may be unreachable.
  void cut_quietly(long size) noexcept;
  void write(std::string_view bytes);
  long written() const { return at_; }        ///< bytes, including those kept by a cut
  std::uint32_t crc() const { return crc_; }  ///< checksum of these bytes
  void finish();                              ///< syncs and closes the file; throws if the system could not write it

 private:
  [[noreturn]] void fail() const;

  std::string name_;
  int fd_ = -1;
  bool regular_ = false, gzip_;
  long at_ = 0;
  std::uint32_t crc_ = 0;
};

/// Checks whether the first bytes of a file are still those written there, packed or not.
class Kept {
 public:
  explicit Kept(const std::string& path) : in_(path, std::ios::binary) {}
  /// Reads on until `bytes` bytes are read; false if the file is shorter or the checksum differs.
  bool holds(long bytes, std::uint32_t crc);
  bool at_end() { return in_.peek() == std::ifstream::traits_type::eof(); }

 private:
  std::ifstream in_;
  long at_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace bankshot::app::batch
