// SPDX-License-Identifier: MIT
#include "support/browser.hpp"

#include <cstdlib>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace bankshot::test {

std::optional<Browsed> browse(const std::string& url, double seconds) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0) {
    CHECK(std::getenv("BANKSHOT_BROWSER") == nullptr);
    WARN("chromium is not installed: the page was not opened in a browser");
    return {};
  }
  const std::string time =
      seconds > 0 ? " --virtual-time-budget=" + std::to_string(static_cast<int>(1000 * seconds)) : "";
  // A browser that hangs is started once more: what it does before it opens the page is not what the test is about.
  const Run run = run_shell(
      "for attempt in 1 2; do\n"
      "profile=$(mktemp -d)\n"
      "timeout --kill-after=5 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking "
      "--disable-component-update --disable-sync --enable-logging=stderr "
      "--host-resolver-rules='MAP * ~NOTFOUND, EXCLUDE 127.0.0.1' --window-size=1200,900 --user-data-dir=\"$profile\"" +
      time + " --dump-dom \"" + url +
      "\"\ncode=$?\nrm -rf \"$profile\"\n[ $code = 124 ] || [ $code = 137 ] || break\ndone\nexit $code");
  CHECK(run.exit == 0);
  return Browsed{run.out, run.err};
}

}  // namespace bankshot::test
