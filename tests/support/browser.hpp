// SPDX-License-Identifier: MIT
//
// Opens a page in a real browser.
#pragma once

#include <optional>
#include <string>

namespace bankshot::test {

struct Browsed {
  std::string dom;  ///< the page after its own scripts have run for `seconds` of virtual time
  std::string log;  ///< the browser's messages; a line with CONSOLE is an error or warning of the page
};

/// Returns none when no browser is installed; with BANKSHOT_BROWSER set, as in CI, that is a failed check. The page can
/// load only what 127.0.0.1 serves.
std::optional<Browsed> browse(const std::string& url, double seconds = 0);

}  // namespace bankshot::test
