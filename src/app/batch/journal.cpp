// SPDX-License-Identifier: MIT
#include "app/batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "app/batch/output.hpp"
#include "app/files.hpp"

namespace bankshot::app::batch {
namespace {

std::string text_of(const Journal::Mark& m) {
  const Tally& t = m.tally;
  return fmt::format("{} {} {:08x} {} {:08x} {} {} {} {} {} {} {} {}\n", m.read.lines, m.read.bytes, m.read.crc,
                     m.written, m.crc, t.solved, t.no_shot, t.budget, t.invalid, t.first_invalid, t.beside,
                     t.simulations, t.worst_miss);
}

std::optional<Journal::Mark> mark_of(const std::string& line) {
  Journal::Mark m;
  Tally& t = m.tally;
  const int n = std::sscanf(line.c_str(), "%ld %ld %" SCNx32 " %ld %" SCNx32 " %ld %ld %ld %ld %ld %ld %ld %lf",
                            &m.read.lines, &m.read.bytes, &m.read.crc, &m.written, &m.crc, &t.solved, &t.no_shot,
                            &t.budget, &t.invalid, &t.first_invalid, &t.beside, &t.simulations, &t.worst_miss);
  constexpr int numbers = 13;
  return n == numbers ? std::optional(m) : std::nullopt;
}

}  // namespace

Journal::Journal(const std::string& output, const std::string& flags, const std::string& input)
    : path_(path_for(output)),
      header_{"bankshot " BANKSHOT_VERSION
              " is not done with the file beside this one; the same command with --resume continues",
              "flags: " + flags, "input: " + input} {
  lock(output);
  read();
}

void Journal::lock(const std::string& output) {
  constexpr mode_t everybody = 0666;  // less the umask
  constexpr int tries = 10;           // another run that ends between two steps of this one costs one try
  for (int i = 0; i < tries; ++i) {
    fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, everybody);
    if (fd_ < 0) throw WriteError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
    if (flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(fd_);
      throw FileError(fmt::format("{}: another bankshot is writing this file", output));
    }
    struct stat ours {
    }, named{};
    if (fstat(fd_, &ours) == 0 && stat(path_.c_str(), &named) == 0 && ours.st_dev == named.st_dev &&
        ours.st_ino == named.st_ino)
      return;
    close(fd_);  // its former holder finished and removed the file
  }
  throw FileError(fmt::format("{}: is another file each time it is opened", path_));
}

Journal::~Journal() {
  if (fd_ >= 0) close(fd_);
}

/// Reads what an earlier run left. A line without its line break was cut off and is ignored.
void Journal::read() {
  std::string text;
  char piece[1 << 16];
  for (ssize_t n = 0; (n = pread(fd_, piece, sizeof piece, static_cast<off_t>(text.size()))) > 0;)
    text.append(piece, static_cast<std::size_t>(n));
  std::size_t begin = 0, row = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1, ++row) {
    const std::string line = text.substr(begin, end - begin);
    if (row < std::size(found_)) {
      found_[row] = line;
      header_read_ = row + 1 == std::size(found_);
    } else if (const auto mark = mark_of(line)) {
      marks_.emplace_back(static_cast<long>(end) + 1, *mark);
    } else {
      return;
    }
  }
}

std::optional<Journal::Mark> Journal::last(const std::string& output) const {
  Kept kept(output);
  std::optional<Mark> last;
  for (const auto& [end, mark] : marks_) {
    if (!kept.holds(mark.written, mark.crc)) break;
    last = mark;
  }
  return last;
}

void Journal::check_same() const {
  if (!header_read_) return;
  const auto value = [](const std::string& line) { return line.substr(std::min(line.size(), line.find(' ') + 1)); };
  const auto refuse = [&](const std::string& what) {
    throw FileError(
        fmt::format("{}: {}; without --resume, and with this file removed, the batch begins again", path_, what));
  };
  if (found_[0] != header_[0]) refuse("another version of bankshot began this batch");
  if (found_[1] != header_[1])
    refuse(
        fmt::format("this batch was begun with other flags: {}; now they are {}", value(found_[1]), value(header_[1])));
  const bool both_known = !value(found_[2]).empty() && !value(header_[2]).empty();
  if (both_known && found_[2] != header_[2])
    refuse(
        fmt::format("this batch was begun with another input: {}; now it has {}", value(found_[2]), value(header_[2])));
}

void Journal::begin() {
  marks_.clear();
  if (ftruncate(fd_, 0) != 0 || lseek(fd_, 0, SEEK_SET) != 0)
    throw WriteError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  append(header_[0] + "\n" + header_[1] + "\n" + header_[2] + "\n");
}

void Journal::go_on(const Mark& m) {
  for (const auto& [end, mark] : marks_)
    if (mark.read.bytes == m.read.bytes && mark.written == m.written &&
        (ftruncate(fd_, end) != 0 || lseek(fd_, end, SEEK_SET) != end))
      throw WriteError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void Journal::add(const Mark& m) { append(text_of(m)); }

void Journal::append(const std::string& text) {
  for (std::string_view left = text; !left.empty();) {
    const ssize_t n = ::write(fd_, left.data(), left.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw WriteError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
    left.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Journal::remove() { unlink(path_.c_str()); }

}  // namespace bankshot::app::batch
