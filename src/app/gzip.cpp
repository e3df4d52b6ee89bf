// SPDX-License-Identifier: MIT
#include "app/gzip.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/files.hpp"

namespace bankshot::app {

std::string gzipped(std::string_view text) {
  constexpr int level = 6, gzip_header = 16, memory = 8;  // zlib's defaults, except for the header
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

ByteReader::ByteReader(const std::string& path) : path_(path), buffer_(256 << 10, '\0') {
  errno = 0;
  gz_ = path == "-" ? gzdopen(dup(STDIN_FILENO), "rb") : gzopen(path.c_str(), "rb");
  if (!gz_) fail();
}

ByteReader::~ByteReader() { gzclose(gz_); }

std::string_view ByteReader::next() {
  errno = 0;
  const int n = gzread(gz_, buffer_.data(), static_cast<unsigned>(buffer_.size()));
  int code = Z_OK;
  gzerror(gz_, &code);
  if (n < 0 || (n == 0 && code != Z_OK && code != Z_STREAM_END)) fail();
  return std::string_view(buffer_).substr(0, static_cast<std::size_t>(n));
}

void ByteReader::fail() const {
  throw FileError(fmt::format("{}: cannot be read: {}", path_ == "-" ? "standard input" : path_,
                              errno ? std::strerror(errno) : "it is no whole gzip file"));
}

}  // namespace bankshot::app
