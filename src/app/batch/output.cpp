// SPDX-License-Identifier: MIT
#include "app/batch/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "app/files.hpp"

namespace bankshot::app::batch {

Output::Output(const std::string& path) : name_(path == "-" ? "standard output" : path), gzip_(path.ends_with(".gz")) {
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

std::string gzipped(std::string_view text) {
  constexpr int level = 6, gzip_header = 16, memory = 8;  // zlib's defaults but for the header
  z_stream z{};
  if (deflateInit2(&z, level, Z_DEFLATED, MAX_WBITS + gzip_header, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw WriteError("zlib cannot begin to compress: out of memory");
  std::string out(deflateBound(&z, text.size()), '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  z.avail_in = static_cast<uInt>(text.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

}  // namespace bankshot::app::batch
