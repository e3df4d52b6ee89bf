// SPDX-License-Identifier: MIT
//
// What makes a batch crash-proof: a small file beside the output (SHOTS.jsonl.progress) that says
// whose answers those are (version, flags, input) and then, a line each time, how far input and
// output have come. An answer is written first and its mark after it, so whatever the moment of a
// kill, the output holds at least what the last whole mark says. Where a machine dies or two write
// at once it may hold less, so a mark has the checksum of both. To resume: find the last mark that
// the output keeps, cut it there, check that the input up to there is the same, go on. The file goes
// when the batch is done.
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
    std::uint32_t crc = 0;  ///< of them
    Tally tally;
  };

  static std::string path_for(const std::string& output) { return output + ".progress"; }

  /// Opens or makes the file; throws FileError where another program is at work on this output. From then on nobody
  /// else is, where the file system has locks.
  Journal(const std::string& output, const std::string& flags, const std::string& input);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The last mark whose answers the output holds, byte for byte; none where nothing is worth keeping.
  std::optional<Mark> last(const std::string& output) const;
  /// Throws FileError when the earlier run had other flags, another input or another version.
  void check_same() const;
  void begin();               ///< empty but for the header
  void go_on(const Mark& m);  ///< behind this mark
  void add(const Mark& m);
  void remove();

 private:
  void lock(const std::string& output);
  void read();
  void append(const std::string& text);

  std::string path_, header_[3];
  int fd_ = -1;
  std::string found_[3];  ///< the header in the file
  bool header_read_ = false;
  std::vector<std::pair<long, Mark>> marks_;  ///< each with where it ends in the file
};

}  // namespace bankshot::app::batch
