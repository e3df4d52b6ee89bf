// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace bankshot::test {

/// A unique file name in the temporary folder; the file is removed with the object.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name)
      : path(
            (std::filesystem::temp_directory_path() / ("bankshot-" + std::to_string(getpid()) + "-" + name)).string()) {
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() { std::filesystem::remove(path); }

  std::string text() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }
  const std::string path;
};

}  // namespace bankshot::test
