// SPDX-License-Identifier: MIT
//
// The journal that makes a batch crash-proof: a small file beside the output (SHOTS.jsonl.progress). It says to what
// the answers belong (version, flags, input) and then, one mark per line, how far input and output have come. An answer
// is written before its mark, so that after a kill the output holds at least what the last complete mark says. If the
// machine dies or two programs write at once, it may hold less; therefore a mark has the checksums of both. To resume,
// bankshot finds the last mark that the output satisfies, cuts the output there, checks that the input up to there is
// unchanged, and continues. The journal is removed when the batch is done.
#pragma once

#include <optional>
#include <string>

#include "app/batch/lines.hpp"
#include "app/batch/tally.hpp"

namespace bankshot::app::batch {

class Journal {
 public:
  struct Mark {
    ReadMark read;
    long written = 0;       ///< bytes of output
    std::uint32_t crc = 0;  ///< checksum of these bytes
    Tally tally;
  };

  static std::string path_for(const std::string& output) { return output + ".progress"; }

  /// Opens or creates the file and locks it, if the file system has locks. Throws FileError if another program is at
  /// work on this output.
  Journal(const std::string& output, const std::string& flags, const std::string& input);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Returns the last mark whose answers the output holds, byte for byte; none if nothing is worth keeping.
  std::optional<Mark> last(const std::string& output) const;
  /// Throws FileError if the earlier run had other flags, another input or another version.
  void check_same() const;
  void begin();               ///< clears the journal and writes the header
  void go_on(const Mark& m);  ///< drops every mark after `m`
  void add(const Mark& m);
  void remove();

 private:
  void lock(const std::string& output);
  void read();
  void append(const std::string& text);

  std::string path_, header_[3];
  int fd_ = -1;
  std::string found_[3];  ///< the header found in the file
  bool header_read_ = false;
  std::vector<std::pair<long, Mark>> marks_;  ///< the marks, each with the offset of its end in the file
};

}  // namespace bankshot::app::batch
