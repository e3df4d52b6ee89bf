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
  const std::string command =
      "profile=$(mktemp -d)\n"
      "timeout --kill-after=5 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --enable-logging=stderr "
      "--host-resolver-rules='MAP * ~NOTFOUND, EXCLUDE 127.0.0.1' --window-size=1200,900 --user-data-dir=\"$profile\"" +
      time + " --dump-dom \"" + url + "\"\ncode=$?\nrm -rf \"$profile\"\nexit $code";
  Run run = run_shell(command);
  // A browser that hangs is started once more: its start is not what a test is about. The codes are those of `timeout`.
  if (run.exit == 124 || run.exit == 137) run = run_shell(command);
  CHECK(run.exit == 0);
  return Browsed{run.out, run.err};
}

}  // namespace bankshot::test
