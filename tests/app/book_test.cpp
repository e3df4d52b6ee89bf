// SPDX-License-Identifier: MIT
//
// `book` as typed in a shell: puzzles in front, answers at the back, headings that name the contents.
#include <algorithm>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace bankshot::test;
using Catch::Contains;

/// Returns puzzles with a range of cushions, seven cushions, a title, any pocket, and no solution.
std::string puzzles(int more) {
  std::string out;
  const std::string scene =
      R"({"table": "seed", "physics": "ideal", "ball": {"at": [0.6, 0.4]}, "target": {"point": [1.9, 0.7]}, )";
  for (int i = 0; i < more; ++i) out += scene + "\"cushions\": {\"min\": 0, \"max\": 2}}\n";
  return out + scene + "\"cushions\": 7, \"about\": {\"title\": \"Seven & <more>\"}}\n" +
         R"({"table": "pool-9ft", "ball": {"at": [1.9, 0.5]}, "target": {"pocket": "any"}, "cushions": 0})" + "\n" +
         R"({"table": "pool-9ft", "ball": {"at": [1.9, 0.5]}, "target": {"pocket": "top-left"}, "cushions": 3, "speed": [0.1, 0.2]})" +
         "\n";
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

}  // namespace

TEST_CASE("book: questions in front, answers at the back, as many as there are") {
  const int more = GENERATE(0, 1, 23);
  const auto all = static_cast<std::size_t>(more) + 3;
  for (const char* suffix : {"html", "svg"}) {
    const ScratchFile page(std::string("book.") + suffix);
    const Run run = run_program("book - -o \"" + page.path + "\"", puzzles(more));
    CHECK(run.exit == 0);
    CHECK(run.err.empty());
    CHECK_THAT(run.out, Catch::StartsWith(std::to_string(all) + " puzzles, " + std::to_string(all - 1) + " solved\n"));
    const std::string text = page.text();
    const std::size_t back = text.find(">Answers<");
    REQUIRE(back != std::string::npos);
    const std::string front = text.substr(0, back), answers = text.substr(back);
    CHECK(count(front, "<svg ") == all + (suffix == std::string("svg") ? 1 : 0));  // the page itself is one
    CHECK(count(answers, "<svg ") == all);
    CHECK_THAT(front, Contains("7 cushions through the ring") && Contains("Straight into any pocket") &&
                          Contains("Seven &amp; &lt;more&gt;") && !Contains("success") && !Contains("no-shot"));
    CHECK(count(answers, "success") >= all - 1);
    CHECK_THAT(text, Contains(std::to_string(all) + " Puzzles") && !Contains("<more>"));
  }
}

TEST_CASE("book: its headings say what is in it") {
  const ScratchFile page("book.html");
  const Run run = run_program("book - -o \"" + page.path + "\"", puzzles(8));
  CHECK_THAT(run.out, Contains("easy") && Contains("without an answer"));
  CHECK_THAT(page.text(), Contains("10 answers found by bankshot"));
}

TEST_CASE("book: bad input is refused with its line") {
  const ScratchFile page("book.html");
  const std::string to = " -o \"" + page.path + "\"";
  const Run bad = run_program("book -" + to, puzzles(1) + "{\"table\": 1}\n");
  CHECK(bad.exit == 2);
  CHECK_THAT(bad.err, Contains("standard input:5: /"));
  CHECK_THAT(run_program("book -" + to, "").err, Contains("there is no puzzle"));
  CHECK_THAT(run_program("book - -o book.txt", puzzles(0)).err, Contains("must end in .html or .svg"));
  CHECK(run_program("book - -o /no/such/folder/b.svg", puzzles(0)).exit == 2);
}
