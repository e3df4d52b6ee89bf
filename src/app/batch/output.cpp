// SPDX-License-Identifier: MIT
#include "app/batch/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

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

void Output::cut(long size) {
  if (ftruncate(fd_, size) != 0 || lseek(fd_, size, SEEK_SET) != size) fail();
  at_ = size;
}

void Output::cut_quietly(long size) noexcept {
  if (fd_ >= 0 && ftruncate(fd_, size) != 0) return;  // the next resume cuts
}

void Output::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at_ += n;
  }
}

void Output::finish() {
  if (fd_ > STDERR_FILENO && close(std::exchange(fd_, -1)) != 0) fail();
}

}  // namespace bankshot::app::batch
