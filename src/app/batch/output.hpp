// SPDX-License-Identifier: MIT
//
// Where answers are written: a file, standard output ("-") or a gzip file (*.gz). A gzip file is a
// row of members, one for each piece written, as gzip allows; so it can be cut between any two of
// them and gone on with.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace bankshot::app::batch {

class Output {
 public:
  /// Opens without changing anything yet. Throws WriteError.
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool regular() const { return regular_; }  ///< a file that can be cut and gone on with
  bool gzip() const { return gzip_; }
  int descriptor() const { return fd_; }
  const std::string& name() const { return name_; }

  long size() const;                           ///< of the file as it is now
  void cut(long size, std::uint32_t crc = 0);  ///< to its first bytes, which have this checksum, and go on behind them
  void cut_quietly(long size) noexcept;        ///< what came after them is not whole; the file may be beyond reach
  void write(std::string_view bytes);
  long written() const { return at_; }        ///< bytes, those before a cut included
  std::uint32_t crc() const { return crc_; }  ///< of them
  void finish();                              ///< on disk and closed; what the system could not write is an error here

 private:
  [[noreturn]] void fail() const;

  std::string name_;
  int fd_ = -1;
  bool regular_ = false, gzip_;
  long at_ = 0;
  std::uint32_t crc_ = 0;
};

/// Whether the first bytes of a file are what was written there, packed or not.
class Kept {
 public:
  explicit Kept(const std::string& path) : in_(path, std::ios::binary) {}
  /// Reads on up to so many bytes; false where they are not there or have another checksum.
  bool holds(long bytes, std::uint32_t crc);
  bool at_end() { return in_.peek() == std::ifstream::traits_type::eof(); }

 private:
  std::ifstream in_;
  long at_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace bankshot::app::batch
