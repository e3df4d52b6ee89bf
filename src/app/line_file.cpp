// SPDX-License-Identifier: MIT
#include "app/line_file.hpp"

namespace bankshot::app {

bool LineFile::next(std::string& line) {
  line.clear();
  if (piece_.empty()) return false;
  ++number;
  while (!piece_.empty()) {
    const std::size_t end = piece_.find('\n');
    line += piece_.substr(0, end);
    if (end != std::string_view::npos) piece_.remove_prefix(end + 1);
    if (end == std::string_view::npos || piece_.empty()) piece_ = bytes_.next();
    if (end != std::string_view::npos) break;
  }
  return true;
}

}  // namespace bankshot::app
