// SPDX-License-Identifier: MIT
#include "app/batch/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "app/batch/lines.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"

namespace bankshot::app::batch {

Output::Output(const std::string& path) : name_(path == "-" ? "standard output" : path), gzip_(is_packed(path)) {
  constexpr mode_t everybody = 0666;  // less the umask
  fd_ = path == "-" ? STDOUT_FILENO : open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, everybody);
  if (fd_ < 0) fail();
  struct stat s {};
  regular_ = path != "-" && fstat(fd_, &s) == 0 && S_ISREG(s.st_mode);
}

Output::~Output() {
  if (fd_ > STDERR_FILENO) close(fd_);
}

void Output::fail() const { throw WriteError(fmt::format("{}: cannot be written: {}", name_, std::strerror(errno))); }

long Output::size() const {
  struct stat s {};
  return fstat(fd_, &s) == 0 ? s.st_size : 0;
}

void Output::cut(long size, std::uint32_t crc) {
  if (ftruncate(fd_, size) != 0 || lseek(fd_, size, SEEK_SET) != size) fail();
  at_ = size;
  crc_ = crc;
}

void Output::cut_quietly(long size) noexcept {
  if (fd_ >= 0 && ftruncate(fd_, size) != 0) return;  // the next resume cuts it
}

void Output::write(std::string_view bytes) {
  crc_ = checksum(crc_, bytes.data(), bytes.size());
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at_ += n;
  }
}

void Output::finish() {
  if (regular_ && fsync(fd_) != 0) fail();
  if (fd_ > STDERR_FILENO && close(std::exchange(fd_, -1)) != 0) fail();
}

bool Kept::holds(long bytes, std::uint32_t crc) {
  char piece[1 << 16];
  while (at_ < bytes && in_) {
    in_.read(piece, std::min<long>(sizeof piece, bytes - at_));
    crc_ = checksum(crc_, piece, static_cast<std::size_t>(in_.gcount()));
    at_ += in_.gcount();
  }
  return at_ == bytes && crc_ == crc;
}

}  // namespace bankshot::app::batch
