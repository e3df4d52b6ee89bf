// SPDX-License-Identifier: MIT
//
// The page's files, which the build puts into the program (cmake/embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace bankshot::app::serve {

struct PageFile {
  std::string_view path, type, bytes;
};
std::span<const PageFile> page_files();

}  // namespace bankshot::app::serve
