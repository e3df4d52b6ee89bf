// SPDX-License-Identifier: MIT
//
// A page in a real browser.
#pragma once

#include <optional>
#include <string>

namespace bankshot::test {

struct Browsed {
  std::string dom;  ///< after the page's own scripts have run for `seconds` of its time
  std::string log;  ///< a line with CONSOLE is a complaint of the page
};

/// None where no browser is installed; that is a failure where BANKSHOT_BROWSER is set, as CI does. The page may load
/// nothing but what lies at 127.0.0.1.
std::optional<Browsed> browse(const std::string& url, double seconds = 0);

}  // namespace bankshot::test
