// SPDX-License-Identifier: MIT
//
// Tries every command line that the program and its documents tell a user to type.
#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace bankshot::test;
using Catch::Contains;

/// Returns the commands that `--help` lists, but `serve`, which waits for a browser.
std::vector<std::string> commands() {
  std::vector<std::string> out;
  const std::string help = run_program("--help").out;
  std::istringstream lines(help.substr(std::min(help.size(), help.find("Subcommands:\n"))));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && !line.empty();)
    if (const std::string name = line.substr(2, line.find(' ', 2) - 2); name != "serve") out.push_back(name);
  return out;
}

/// Runs lines in a temporary folder that holds the files they use, with `bankshot` as a command. There `puzzle.json` is
/// the three-line puzzle of docs/format.md.
Run type(const std::string& lines) {
  const std::string text = read_repository_file("docs/format.md"), begin = "```json\n";
  const std::size_t at = text.find(begin) + begin.size();
  const std::string puzzle = text.substr(at, text.find("```", at) - at);
  return run_shell(R"(set -e; folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT; cd "$folder"
ln -s PROGRAM bankshot; PATH=$folder:$PATH
cat >puzzle.json; tr -d '\n' <puzzle.json >puzzles.jsonl; echo >>puzzles.jsonl
echo '{"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "others": [{"id": "1", "at": [1.6, 0.9]},'\
  '{"id": "2", "at": [2.2, 0.4]}, {"id": "3", "at": [0.5, 1]}, {"id": "8", "at": [1.2, 0.3]}]}' >rack.json
echo '{"table": "seed", "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 1, "angle": 20}}' >shot.json
bankshot batch puzzles.jsonl -o shots.jsonl --quiet
for angle in 20 75; do
  echo '{"table": "seed", "physics": {"model": "spin"}, "ball": {"at": [0.5, 0.5]},'\
    '"shot": {"speed": 2, "angle": '$angle'}}' >recorded.json
  bankshot simulate recorded.json --record 60 --noise 2 --seed $angle >>recordings.jsonl
  tail -n 1 recordings.jsonl | sed 's/}$/,"shot":{"speed":2,"angle":'$angle'}}/' >>attempts.jsonl
done
for part in 0 1; do bankshot batch puzzles.jsonl --part $part/2 -o shots-$part.jsonl --quiet; done
)" + lines,
                   puzzle);
}

std::vector<std::string> examples(const std::string& help) {
  std::vector<std::string> out;
  std::istringstream lines(help.substr(std::min(help.size(), help.find("Examples:\n"))));
  for (std::string line; std::getline(lines, line) && !line.starts_with("Exit codes");)
    if (line.starts_with("  bankshot ")) out.push_back(line.substr(2, line.find("  ", 3) - 2));
  return out;
}

/// Makes a report quick for a test: two shots per point.
std::string quick(const std::string& line) { return line.starts_with("bankshot report") ? line + " --shots 2" : line; }

}  // namespace

TEST_CASE("every --help has examples that work, and its exit codes", "[heavy]") {
  const std::vector<std::string> all = commands();
  REQUIRE(all.size() >= 14);
  for (const std::string& command : all) {
    INFO(command);
    const std::string help = run_program(command + " --help").out;
    CHECK_THAT(help, Contains("Exit codes: 0 "));
    CHECK(run_program("help " + command).out == help);
    REQUIRE(!examples(help).empty());
    for (const std::string& line : examples(help)) {
      INFO(line);
      const Run run = type(quick(line));
      CHECK(run.exit == 0);
      CHECK_THAT(run.err, !Contains("bankshot: "));
    }
    // Each short option has a long one beside it.
    const std::regex alone("\n  -[a-z] ");
    CHECK(!std::regex_search(help, alone));
  }
  CHECK(run_program("help").out == run_program("--help").out);
  for (const std::string& line : examples(run_program("--help").out)) CHECK(type(line).exit == 0);
  const Run wrong = run_program("help slove");
  CHECK(wrong.exit == 2);
  CHECK_THAT(wrong.err, Contains("did you mean \"solve\"?"));
}

TEST_CASE("every line that a document says to type works", "[heavy]") {
  int typed = 0;
  for (const char* document : {"docs/format.md", "docs/csv.md"}) {
    const std::string text = read_repository_file(document);
    const std::regex block("```sh\n([^`]*)```");
    for (std::sregex_iterator it(text.begin(), text.end(), block), end; it != end; ++it) {
      std::istringstream lines((*it)[1]);
      std::string all;
      for (std::string line; std::getline(lines, line); ++typed) all += quick(line) + "\n";
      INFO(document << "\n" << all);
      const Run run = type(all);
      INFO(run.err);
      CHECK(run.exit == 0);
    }
  }
  CHECK(typed >= 10);
}

TEST_CASE("docs/csv.md has every column of every table", "[heavy]") {
  const std::string text = read_repository_file("docs/csv.md");
  std::set<std::string> columns;
  const Run run = type(R"(bankshot simulate shot.json --csv - | head -n 1
bankshot solve puzzle.json --all --csv - | head -n 1
bankshot map puzzle.json --grid 2 2 -o map.csv >map.txt; head -n 1 map.csv
bankshot pocket pool-9ft top-left -o window.csv >window.txt; head -n 1 window.csv
bankshot batch puzzles.jsonl --cost cost.csv --quiet >shots.txt; head -n 1 cost.csv
bankshot report -o report --quick --shots 2 2>log.txt >page.txt
for table in report/*.csv; do head -n 1 "$table"; done)");
  REQUIRE(run.exit == 0);
  std::string heads = run.out;
  for (const char* table : {"acceptance", "all-shots", "batch", "breaks", "cluster", "page", "planners-rolling",
                            "planners-spin", "pockets", "shots", "stress", "simulate"}) {
    const std::string csv = read_repository_file(fmt::format("tests/bench/results/{}.csv", table));
    heads += csv.substr(0, csv.find('\n') + 1);
  }
  std::istringstream lines(heads);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream names(line);
    for (std::string name; std::getline(names, name, ',');)
      columns.insert(std::regex_replace(name, std::regex("\""), ""));
  }
  columns.erase("events");  // Google Benchmark's counters are documented where they are counted
  for (const std::string& column : columns) {
    INFO(column);
    CHECK(text.find("`" + column + "`") != std::string::npos);
  }
  CHECK(columns.size() > 80);
}

TEST_CASE("manual pages name every option") {
  CHECK_THAT(run_program("man").out, Catch::StartsWith(".TH bankshot 1") && Contains("\\fBcompletion\\fR"));
  const std::vector<std::string> all = commands();
  REQUIRE(all.size() >= 14);
  for (const std::string& command : all) {
    INFO(command);
    const std::string page = run_program("man " + command).out, help = run_program(command + " --help").out;
    for (const char* heading : {".SH NAME\nbankshot", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXAMPLES", ".SH EXIT STATUS"})
      CHECK_THAT(page, Contains(heading));
    const std::regex option("--[a-z][a-z-]*");
    std::string plain = std::regex_replace(page, std::regex("\\\\-"), "-");
    const std::string listed = help.substr(0, help.find("Examples:"));
    for (std::sregex_iterator it(listed.begin(), listed.end(), option), end; it != end; ++it)
      CHECK_THAT(plain, Contains(it->str()));
  }
  CHECK(run_program("man slove").exit == 2);
}

TEST_CASE("a shell completes commands, options and words") {
  const auto completed = [](const std::string& words) {
    return run_shell("bash -c 'source <(PROGRAM completion bash); COMP_WORDS=(" + words +
                     "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _bankshot; echo \"${COMPREPLY[@]}\"'")
        .out;
  };
  CHECK(completed("bankshot so") == "solve\n");
  CHECK(completed("bankshot help ver") == "verify\n");
  CHECK(completed("bankshot solve --no-t") == "--no-timing\n");
  CHECK(completed("bankshot generate --target p") == "pocket pass pot\n");
  CHECK(completed("bankshot completion z") == "zsh\n");
  CHECK(completed("bankshot schema an") == "answer\n");
  for (const char* shell : {"zsh", "fish"})
    CHECK_THAT(run_program(std::string("completion ") + shell).out,
               Contains("no-robustness") && Contains("difficulty"));
  CHECK(run_program("completion csh").exit == 2);
}
