// SPDX-License-Identifier: MIT
#include "app/batch/lines.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/files.hpp"
#include "app/interrupt.hpp"

namespace bankshot::app::batch {
namespace {

constexpr std::size_t buffer_size = 256 << 10;

}  // namespace

std::uint32_t checksum(std::uint32_t before, const char* data, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(data), size));
}

LineReader::LineReader(const std::string& path, bool whole_chunks)
    : name_(path == "-" ? "standard input" : path), whole_chunks_(whole_chunks), buffer_(buffer_size, '\0') {
  fd_ = path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd_ < 0) throw FileError(fmt::format("{}: cannot be read: {}", name_, std::strerror(errno)));
  struct stat s {};
  if (fstat(fd_, &s) == 0 && S_ISREG(s.st_mode)) size_ = s.st_size;
  if (!path.ends_with(".gz")) return;
  gz_ = gzdopen(dup(fd_), "rb");
  if (!gz_) throw FileError(fmt::format("{}: cannot be read: {}", name_, std::strerror(errno)));
  gzbuffer(gz_, buffer_size);
}

LineReader::LineReader(const std::string& path, bool whole_chunks, const Part& part) : LineReader(path, whole_chunks) {
  if (size_ < 0) throw FileError(fmt::format("{}: only a file has parts", name_));
  if (part.n > 1) find(part);
}

/// Moves to the first line of the part. A line belongs to the part in which it begins; offsets count unpacked bytes.
void LineReader::find(const Part& part) {
  long bytes = size_;
  if (gz_) {
    bytes = 0;
    while (fill()) bytes += static_cast<long>(end_);
    begin_ = end_ = 0;
    gzrewind(gz_);
  }
  const auto cut = [&](long k) { return bytes / part.n * k + bytes % part.n * k / part.n; };
  const long from = cut(part.k);
  until_ = cut(part.k + 1);
  // Skips to `from`, and past the line that crosses it, which belongs to an earlier part.
  while (mark_.bytes < from && (begin_ < end_ || fill())) {
    const char* const data = buffer_.data() + begin_;
    const std::size_t most = std::min(end_ - begin_, static_cast<std::size_t>(from - mark_.bytes));
    const auto* const last = static_cast<const char*>(memrchr(data, '\n', most));
    const bool begins = mark_.bytes + static_cast<long>(most) == from;
    mark_.lines += std::count(data, data + most, '\n');
    mark_.crc = checksum(mark_.crc, data, most);
    mark_.bytes += static_cast<long>(most);
    begin_ += most;
    if (!begins || last == data + most - 1) continue;
    bool whole = false;
    while (!whole && (begin_ < end_ || fill())) {
      const char* const rest = buffer_.data() + begin_;
      const auto* const line_break = static_cast<const char*>(std::memchr(rest, '\n', end_ - begin_));
      whole = line_break != nullptr;
      const std::size_t used = whole ? static_cast<std::size_t>(line_break - rest) + 1 : end_ - begin_;
      mark_.crc = checksum(mark_.crc, rest, used);
      mark_.bytes += static_cast<long>(used);
      begin_ += used;
    }
    ++mark_.lines;  // counts that line; the last line of the input may lack its line break
  }
  begun_ = mark_;
}

LineReader::~LineReader() {
  if (gz_) gzclose(gz_);
  if (fd_ > STDIN_FILENO) close(fd_);
}

bool LineReader::next(Lines& out) {
  out.text.clear();
  out.lines.clear();
  try {
    while (out.lines.size() < lines_a_chunk && out.text.size() < bytes_a_chunk && mark_.bytes < until_) {
      if (!out.lines.empty() && !whole_chunks_ && !more_is_there()) break;
      if (!add_line(out)) break;
    }
  } catch (const FileError&) {
    if (out.lines.empty()) throw;  // else it is thrown again after the lines before it
  }
  if (whole_chunks_ && interrupted()) return false;  // a shorter chunk would cut the input differently
  out.after = mark_;
  out.share = share();
  return !out.lines.empty();
}

/// Reads one line; the last may lack its line break. `mark_` moves by whole lines only.
bool LineReader::add_line(Lines& out) {
  const std::size_t start = out.text.size();
  ReadMark mark = mark_;
  bool too_long = false, whole = false;
  const auto more = [&] {
    if (begin_ < end_) return true;
    try {
      return fill();
    } catch (const FileError&) {
      out.text.resize(start);  // drops the incomplete line
      throw;
    }
  };
  while (!whole && more()) {
    const char* from = buffer_.data() + begin_;
    const std::size_t left = end_ - begin_;
    const auto* line_break = static_cast<const char*>(std::memchr(from, '\n', left));
    whole = line_break != nullptr;
    const std::size_t n = whole ? static_cast<std::size_t>(line_break - from) : left, used = n + (whole ? 1 : 0);
    const std::size_t room = longest_line - (out.text.size() - start);
    out.text.append(from, std::min(n, room));
    too_long = too_long || n > room;
    mark.crc = checksum(mark.crc, from, used);
    mark.bytes += static_cast<long>(used);
    begin_ += used;
  }
  if (mark.bytes == mark_.bytes) return false;
  if (!whole && interrupted()) {
    out.text.resize(start);
    return false;
  }
  ++mark.lines;
  mark_ = mark;
  out.lines.push_back({start, out.text.size() - start, too_long});
  return true;
}

bool LineReader::skip(const ReadMark& mark) {
  while (mark_.bytes < mark.bytes && (begin_ < end_ || fill())) {
    const std::size_t n = std::min(end_ - begin_, static_cast<std::size_t>(mark.bytes - mark_.bytes));
    mark_.crc = checksum(mark_.crc, buffer_.data() + begin_, n);
    mark_.bytes += static_cast<long>(n);
    begin_ += n;
  }
  mark_.lines = mark.lines;
  return mark_.bytes == mark.bytes && mark_.crc == mark.crc;
}

bool LineReader::fill() {
  begin_ = end_ = 0;
  if (gz_) {
    const int n = gzread(gz_, buffer_.data(), static_cast<unsigned>(buffer_size));
    int code = Z_OK;
    const char* reason = gzerror(gz_, &code);
    if (n <= 0 && code != Z_OK)
      throw FileError(fmt::format("{}: cannot be read: {}", name_,
                                  code == Z_BUF_ERROR ? "the compressed data end too early"
                                  : code == Z_ERRNO   ? std::strerror(errno)
                                                      : reason));
    end_ = n > 0 ? static_cast<std::size_t>(n) : 0;
    return n > 0;
  }
  while (wait_for_input()) {
    const ssize_t n = read(fd_, buffer_.data(), buffer_size);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n < 0) throw FileError(fmt::format("{}: cannot be read: {}", name_, std::strerror(errno)));
    end_ = static_cast<std::size_t>(n);
    return n > 0;
  }
  return false;
}

/// Waits until input arrives; false once interrupted. It wakes regularly, since the signal may reach another thread.
bool LineReader::wait_for_input() const {
  constexpr int patience = 100;  // ms
  while (size_ < 0 && !interrupted()) {
    pollfd wait{fd_, POLLIN, 0};
    if (poll(&wait, 1, patience) > 0) return true;
  }
  return !interrupted();
}

/// Returns whether more input is available without waiting.
bool LineReader::more_is_there() const {
  if (size_ >= 0 || gz_ || std::memchr(buffer_.data() + begin_, '\n', end_ - begin_)) return true;
  pollfd look{fd_, POLLIN, 0};
  return begin_ == end_ && poll(&look, 1, 0) > 0;
}

double LineReader::share() const {
  if (size_ <= 0) return -1;
  if (until_ < std::numeric_limits<long>::max())
    return std::min(1.0, static_cast<double>(mark_.bytes - begun_.bytes) /
                             std::max(1.0, static_cast<double>(until_ - begun_.bytes)));
  const auto behind = gz_ ? static_cast<double>(gzoffset(gz_)) : static_cast<double>(mark_.bytes);
  return std::min(1.0, behind / static_cast<double>(size_));
}

std::string LineReader::identity() const {
  if (size_ < 0) return "";
  constexpr long tail = 1 << 16;  // bytes
  std::string end(static_cast<std::size_t>(std::min(size_, tail)), '\0');
  const ssize_t n = pread(fd_, end.data(), end.size(), size_ - static_cast<long>(end.size()));
  return fmt::format("{} bytes, the end with CRC {:08x}", size_,
                     n > 0 ? checksum(0, end.data(), static_cast<std::size_t>(n)) : 0);
}

bool LineReader::same_file(int descriptor) const {
  struct stat a {
  }, b{};
  return size_ >= 0 && fstat(fd_, &a) == 0 && fstat(descriptor, &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

}  // namespace bankshot::app::batch
