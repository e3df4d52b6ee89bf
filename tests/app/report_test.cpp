// SPDX-License-Identifier: MIT
//
// Tests `report` as typed in a shell, with as few shots as possible: its files, and how a browser without a network
// shows its page.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/scratch_file.hpp"
#include "support/browser.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;

constexpr const char* sections[] = {"1-simulators", "2-models",  "3-planners", "4-conditioning",
                                    "5-hard-cases", "6-scaling", "7-tilt"};

/// A temporary folder that is removed with its contents.
struct ScratchFolder : ScratchFile {
  using ScratchFile::ScratchFile;
  ~ScratchFolder() { std::filesystem::remove_all(path); }
  std::string file(const std::string& name) const { return path + "/" + name; }
  std::string read(const std::string& name) const {
    std::ifstream in(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Checks that every line has as many fields as the first; commas inside quotes do not count.
void check_csv(const std::string& text) {
  std::istringstream in(text);
  const auto fields = [](const std::string& line) {
    bool quoted = false;
    return std::count_if(line.begin(), line.end(),
                         [&](char c) { return c == '"' ? (quoted = !quoted, false) : c == ',' && !quoted; });
  };
  std::string header;
  std::getline(in, header);
  long rows = 0;
  for (std::string line; std::getline(in, line); ++rows)
    if (fields(line) != fields(header)) FAIL(header << " but " << line);
  CHECK(rows > 3);
}

void check_files(const ScratchFolder& folder, bool figures) {
  const std::string markdown = folder.read("report.md");
  for (const std::string name : sections) {
    INFO(name);
    check_csv(folder.read(name + ".csv"));
    CHECK((folder.read("figures/" + name + ".svg").find("</svg>") != std::string::npos) == figures);
    CHECK((markdown.find("(figures/" + name + ".svg)") != std::string::npos) == figures);
    CHECK_THAT(markdown, Contains(name + ".csv"));
  }
  CHECK(count(markdown, "\n**") == std::size(sections));  // each section has a conclusion
}

/// Returns the page with a script that measures its figures.
std::string that_measures_itself(const ScratchFolder& folder) {
  std::string page = folder.read("index.html");
  const std::string script =
      "<script>let n = 0; for (const f of document.querySelectorAll('figure svg')) { const b = "
      "f.getBoundingClientRect();"
      " if (b.width > 300 && b.height > 100 && f.querySelectorAll('path').length > 20) ++n; } document.title = n + ' "
      "figures, wide ' +"
      " (document.documentElement.scrollWidth > window.innerWidth);</script></body>";
  page.replace(page.rfind("</body>"), 7, script);
  std::ofstream(folder.file("checked.html"), std::ios::binary) << page;
  return "file://" + folder.file("checked.html");
}

}  // namespace

TEST_CASE("report writes a page that opens offline and shows every figure", "[heavy]") {
  const ScratchFolder folder("it's-a-report");
  const auto run = run_program("report --quick --shots 1 -o \"" + folder.path + "\"");
  CHECK(run.exit == 0);
  CHECK(run.err.empty());  // no progress bar without a terminal
  for (const char* title :
       {"Simulators: ", "Models: ", "Planners: ", "Conditioning: ", "Hard cases: ", "Scaling: ", "Tilt: "})
    CHECK_THAT(run.out, Contains(title));
  check_files(folder, true);
  const std::string page = folder.read("index.html");
  CHECK(count(page, "<svg ") == std::size(sections));
  CHECK(count(page, "<table>") == std::size(sections));
  CHECK(count(page, "class=\"conclusion\"") == std::size(sections));
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "<script"}) CHECK(count(page, outside) == 0);
  CHECK_THAT(page, Contains("commit ") && Contains("core"));

  const auto browsed = bankshot::test::browse(that_measures_itself(folder));
  if (!browsed) return;
  CHECK_THAT(browsed->dom, Contains("<title>7 figures, wide false</title>"));
  CHECK(count(browsed->log, "CONSOLE") == 0);
}

TEST_CASE("without gnuplot report says so, names the package and writes the numbers", "[heavy]") {
  const ScratchFolder folder("report-without-gnuplot");
  const char* const found = std::getenv("PATH");
  const std::string path = found ? found : "";
  setenv("PATH", "/nonexistent", 1);
  const auto run = run_program("report --quick --shots 1 -o \"" + folder.path + "\"");
  setenv("PATH", path.c_str(), 1);
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains("gnuplot-nox"));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  check_files(folder, false);
  CHECK(!std::filesystem::exists(folder.file("index.html")));
}

TEST_CASE("report says which law of the cushions explains recorded shots", "[heavy]") {
  std::string lines;
  constexpr int shots = 4;
  for (int i = 0; i < shots; ++i) {
    const std::string shot = fmt::format(
        R"({{"id": "shot {}", "table": "carom-10ft", "physics": {{"model": "spin", "cushion": {{"model": "stronge", "friction": 0.3}}}},
  "ball": {{"at": [{}, 0.4]}}, "shot": {{"speed": 3, "angle": {}, "spin": {{"top": 0.5, "side": {}}}}}, "until": {{"time": 2}}}})",
        i, 0.5 + 0.1 * i, 20 + 50 * i, 0.2 * i - 0.5);
    const auto run = run_program(fmt::format("simulate - --record 50 --noise 0.5 --seed {}", i), shot);
    REQUIRE(run.exit == 0);
    lines += run.out;
  }
  const ScratchFile recordings("report.jsonl");
  recordings.write(lines + "{}\n");
  const ScratchFolder folder("report-of-recordings");
  const auto run =
      run_program("report --quick --sections recorded --recordings " + recordings.path + " -o \"" + folder.path + "\"");
  CHECK(run.exit == 0);
  CHECK_THAT(run.err, Contains(":5: ") && Contains("1 of 5 lines were left out"));
  CHECK_THAT(run.out, Contains("Models against real shots: The cushion law stronge explains these shots best. ") &&
                          Contains(" Of 4 shots that go on after their first part, it predicts half within "));
  CHECK(std::count(run.out.begin(), run.out.end(), '\n') == 1);  // this section alone
  check_csv(folder.read("8-recorded-shots.csv"));
  const std::string csv = folder.read("8-recorded.csv"), markdown = folder.read("report.md");
  CHECK(csv.rfind("model,shots,rms_median_mm,", 0) == 0);
  for (const char* law : {"mirror", "han2005", "stronge"}) {
    CHECK_THAT(csv, Contains(fmt::format("\n\"{}\",4,", law)));
    CHECK_THAT(markdown, Contains(fmt::format("\n| {} | ", law)));
  }
  CHECK_THAT(markdown, Contains("(figures/8-recorded.svg)"));
  CHECK_THAT(folder.read("figures/8-recorded.svg"), Contains("</svg>"));
}

TEST_CASE("report --help names its options") {
  const auto run = run_program("report --help");
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, Contains("--quick") && Contains("--output"));
}

TEST_CASE("report refuses what it cannot do in one line") {
  const auto [arguments, reason] =
      GENERATE(table<const char*, const char*>({{"report", "--output"},
                                                {"report -o --quick", "is an option, not a file"},
                                                {"report -o /dev/null/report", "/dev/null/report"},
                                                {"report -o x --sections tilt,recorded", "needs --recordings"},
                                                {"report -o x --sections colours", "--sections"},
                                                {"report -o x --recordings /dev/null", "no recording in it"}}));
  const auto run = run_program(arguments);
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains(reason));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}
