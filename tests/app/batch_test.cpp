// SPDX-License-Identifier: MIT
//
// `bankshot batch` as a user meets it: it writes one line for each line it reads, whatever the lines, the threads and
// the files. Its messages are tested too.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/batch/rows.hpp"
#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::run_program;
using bankshot::test::run_shell;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Catch::StartsWith;
using Json = nlohmann::json;

/// Returns a puzzle that has one shot, as a program would write it.
std::string line(int i) {
  return R"({"id": )" + std::to_string(i) + R"(, "table": "seed", "physics": "rolling", "ball": {"at": [)" +
         std::to_string(0.5 + 0.003 * i) +
         R"(, 0.4]}, "target": {"point": [1.5, 1.0]}, "cushions": ["top", "bottom"]})";
}

std::string lines(int from, int to) {
  std::string out;
  for (int i = from; i < to; ++i) out += line(i) + "\n";
  return out;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    out.push_back(text.substr(begin, end - begin));
  CHECK((text.empty() || text.back() == '\n'));
  return out;
}

const std::string batch = "batch --no-timing --quiet ";

struct File : ScratchFile {
  File(const std::string& name, const std::string& content) : ScratchFile(name) {
    std::ofstream(path, std::ios::binary) << content;
  }
  explicit File(const std::string& name) : ScratchFile(name) {}
  ~File() { std::filesystem::remove(path + ".progress"); }
  std::string quoted() const { return "\"" + path + "\""; }
};

}  // namespace

TEST_CASE("a batch answers each line with what solve --json prints for it, and exit code 0") {
  const std::vector<std::string> in{
      line(1),
      "",
      "  ",
      "no puzzle",
      R"({"id": "x", "tabel": 1})",
      line(2) + "\r",
      "\r",
      "[1, 2]",
      R"({"id": 1e3})",
      "{\"id\": \"" + std::string(100000, 'x') + "\"}",
      line(3) + std::string(3, '\0'),
      std::string(R"({"id": "é)") + "\xff\"}",
      R"({"id": 9, "table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "top-right"}, "speed": [0.1, 0.2]})"};
  std::string text;
  for (const std::string& l : in) text += l + "\n";
  const auto run = run_program(batch + "-", text);
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  const std::vector<std::string> out = split(run.out);
  REQUIRE(out.size() == in.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    INFO(i << ": " << in[i].substr(0, 100));
    Json answer = Json::parse(run_program("solve --json --no-timing", in[i]).out);
    const std::string number = "line " + std::to_string(i + 1) + ": ";
    for (Json* words : {&answer["message"], answer.contains("error") ? &answer["error"]["reason"] : &answer["message"]})
      if (const std::string said = *words; said.starts_with("line 1: "))
        *words = number + (said.ends_with("the document is empty") ? "blank line" : said.substr(8));
    CHECK(Json::parse(out[i]) == answer);
  }
  CHECK(Json::parse(out[0]).at("status") == "solved");
  CHECK(Json::parse(out[1]).at("error").at("reason") == "line 2: blank line");
  CHECK(Json::parse(out[3]).at("status") == "invalid");
  CHECK_THAT(Json::parse(out[3]).at("error").at("reason").get<std::string>(), Contains("line 4: not JSON"));
  CHECK(Json::parse(out[4]).at("error").at("path") == "/tabel");
  CHECK(Json::parse(out[10]).at("error").at("reason") == "line 11: not JSON: there is a zero byte");
}

TEST_CASE("batch --csv has a row for each answer") {
  const File in("rows-in.jsonl", line(1) + "\nno puzzle\n" + line(2) + "\n"), out("rows.jsonl");
  const ScratchFile csv("rows.csv");
  const auto run = run_program(batch + in.quoted() + " -o " + out.quoted() + " --csv \"" + csv.path + "\"");
  CHECK(run.exit == 0);
  const std::vector<std::string> rows = split(csv.text()), answers = split(out.text());
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] + "\n" == bankshot::app::batch::rows_header());
  for (std::size_t i = 0; i < answers.size(); ++i)
    CHECK(rows[i + 1] + "\n" == bankshot::app::batch::row_of(static_cast<long>(i) + 1, answers[i]));
  const Json first = Json::parse(answers[0]);
  CHECK_THAT(rows[1], StartsWith("1,1,solved,1," + first["shots"][0]["speed"].dump() + ","));
  CHECK_THAT(rows[2], StartsWith("2,,invalid,0,,,"));
  // A name with a comma is quoted.
  CHECK(bankshot::app::batch::row_of(3, R"({"id": "a,b", "status": "no-shot", "shots": []})")
            .starts_with("3,\"a,b\",no-shot,0,"));
  const auto nowhere = run_program(batch + in.quoted() + " --csv \"" + csv.path + "\"");
  CHECK(nowhere.exit == 2);
  CHECK_THAT(nowhere.err, Contains("-o SHOTS.jsonl"));
}

TEST_CASE("the last line may lack its line break, the first may begin with a byte order mark") {
  const std::string whole = run_program(batch + "-", lines(0, 3)).out;
  CHECK(split(whole).size() == 3);
  CHECK(run_program(batch + "-", lines(0, 2) + line(2)).out == whole);
  CHECK(run_program(batch + "-", "\xef\xbb\xbf" + lines(0, 3)).out == whole);
  CHECK(run_program(batch + "-", "").out.empty());
  CHECK(split(run_program(batch + "-", "\n").out).size() == 1);
}

TEST_CASE("a line that no puzzle needs is answered without being held in memory") {
  const std::string text = line(0) + "\n{\"id\": 5, \"" + std::string(5'000'000, 'x') + "\n" + line(1);
  const std::vector<std::string> out = split(run_program(batch + "-", text).out);
  REQUIRE(out.size() == 3);
  CHECK_THAT(Json::parse(out[1]).at("error").at("reason").get<std::string>(), Contains("longer than 4194304 bytes"));
  CHECK(Json::parse(out[1]).at("id") == 5);
  CHECK(Json::parse(out[2]).at("id") == 1);
}

TEST_CASE("the output has the same bytes for any number of threads, packed or not") {
  const File in("batch-in.jsonl", lines(0, 300)), packed_in("batch-in.jsonl.gz"), out("batch-out.jsonl"),
      packed("batch-out.jsonl.gz");
  const std::string whole = run_program(batch + in.quoted()).out;
  CHECK(split(whole).size() == 300);
  std::string packed_bytes;
  for (const char* const threads : {"1", "2", "7", "0"}) {
    const std::string command = fmt::format("{}{} -j {}", batch, in.quoted(), threads);
    CHECK((run_program(command).out == whole));
    CHECK(run_program(fmt::format("{} -o {}", command, out.quoted())).exit == 0);
    CHECK((out.text() == whole));
    CHECK(run_program(fmt::format("{} -o {}", command, packed.quoted())).exit == 0);
    if (packed_bytes.empty()) packed_bytes = packed.text();
    CHECK((packed.text() == packed_bytes));
    CHECK((packed.text().starts_with("\x1f\x8b")));
    CHECK(packed.text().size() < whole.size() / 2);
  }
  CHECK(!std::filesystem::exists(out.path + ".progress"));
  // The packed answers serve as input: each line is read, and none is a puzzle.
  CHECK(split(run_program(batch + packed.quoted()).out).size() == 300);
  std::ofstream(packed_in.path, std::ios::binary) << packed_bytes.substr(0, packed_bytes.size() / 2);
  const auto cut = run_program(batch + packed_in.quoted());
  CHECK(cut.exit == 2);
  CHECK_THAT(cut.err, Contains("the compressed data end too early; answers written: 1"));
}

TEST_CASE("a batch takes the flags of solve") {
  const std::string puzzle =
      R"({"table": "seed", "physics": "spin", "ball": {"at": [0.5, 0.4]}, "target": {"point": [1.5, 1]}, "cushions": 2})";
  for (const std::string flags : {"--all", "--budget 3", "--planner sweep", "--no-robustness", "--json"})
    CHECK(run_program("batch - --quiet --no-timing " + flags, puzzle).out ==
          run_program("solve --json --no-timing " + flags, puzzle).out);
  CHECK(Json::parse(run_program("batch --quiet -", puzzle).out).contains("time_us"));
  const std::string planners = run_program("batch --planner list -").out;
  CHECK_THAT(planners, Contains("sweep"));
  CHECK((planners.find("nlopt-direct") != std::string::npos) == bool{BANKSHOT_NLOPT});
}

TEST_CASE("a batch ends with a line that sums it up, and says nothing when quiet") {
  const std::string text = lines(0, 5) + "\n" + line(6);
  const auto run = run_program("batch -", text);
  CHECK_THAT(run.err, Contains("7 puzzles in ") &&
                          Contains(" a second: 6 solved, 0 no-shot, 1 invalid (the first on line 6); worst miss "));
  CHECK(split(run.err).size() == 1);  // no progress is shown without a terminal
  CHECK(run_program("batch --quiet -", text).err.empty());
}

TEST_CASE("a batch that cannot be is refused with the reason in one line") {
  const File in("batch-refused.jsonl", lines(0, 2));
  const auto [arguments, reason] = GENERATE(table<std::string, std::string>({
      {"", "puzzles is required"},
      {"/no/such/file.jsonl", "/no/such/file.jsonl: cannot be read: No such file"},
      {"/", "/: cannot be read: Is a directory"},
      {"IN -o /no/such/folder/out", "/no/such/folder/out: cannot be written: No such file"},
      {"IN -o /", "/: cannot be written: Is a directory"},
      {"IN -o IN", "is the input too, and would be overwritten"},
      {"IN -o /dev/full", "/dev/full: cannot be written: No space left on device; answers written: 0"},
      {"IN >/dev/full", "standard output: cannot be written: No space left on device"},
      {"IN --resume", "--resume needs the file to continue"},
      {"IN --resume -o /dev/null", "/dev/null: is no file that can be resumed"},
      {"IN --svg x.svg", "a batch draws no pictures"},
      {"IN -j -1", "--threads"},
      {"IN --planner imge", "did you mean \"image\"?"},
  }));
  std::string command = arguments;
  for (std::size_t at; (at = command.find("IN")) != std::string::npos;) command.replace(at, 2, in.quoted());
  const auto run = run_program("batch --quiet " + command);
  INFO(run.err);
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Catch::StartsWith("bankshot: ") && Contains(reason));
  CHECK(run.err.find('\n') == run.err.size() - 1);
  CHECK(in.text() == lines(0, 2));
}

TEST_CASE("a closed pipe ends a batch with an error, not silently") {
  const auto run = run_shell("{ PROGRAM batch --quiet -; echo \"exit $?\" >&2; } | head -n 1",
                             lines(0, 300) + lines(0, 300) + lines(0, 300));
  CHECK(split(run.out).size() == 1);
  CHECK_THAT(run.err, Contains("standard output: cannot be written: Broken pipe") && Catch::EndsWith("exit 2\n"));
}

TEST_CASE("a full disk loses nothing: a later --resume completes the output") {
  const File in("batch-full.jsonl", lines(0, 300)), out("batch-full-out.jsonl");
  const std::string whole = run_program(batch + in.quoted()).out;
  // Files may grow to 200 blocks, which are 512 bytes each in most shells.
  const auto stopped = run_shell("ulimit -f 200; PROGRAM " + batch + in.quoted() + " -o " + out.quoted());
  CHECK(stopped.exit == 2);
  CHECK_THAT(stopped.err,
             Contains("cannot be written: File too large; answers written: ") && Contains("--resume continues"));
  const std::string part = out.text();
  REQUIRE(!part.empty());
  CHECK(part.size() < whole.size());
  CHECK((whole.starts_with(part)));
  CHECK(part.back() == '\n');

  const auto again = run_program(batch + in.quoted() + " -o " + out.quoted());
  CHECK(again.exit == 2);
  CHECK_THAT(again.err, Contains("of a batch that was interrupted: --resume continues it"));
  CHECK((out.text() == part));
  const std::string resume = " --resume -o " + out.quoted();
  const auto other_flags = run_program(batch + "--all " + in.quoted() + resume);
  CHECK(other_flags.exit == 2);
  CHECK_THAT(other_flags.err,
             Contains("with other flags: --planner auto --no-timing; now they are --planner auto --all --no-timing"));
  const File other("batch-other.jsonl", lines(1, 301));
  const auto other_input = run_program(batch + other.quoted() + resume);
  CHECK(other_input.exit == 2);
  CHECK_THAT(other_input.err, Contains("with another input"));
  CHECK((out.text() == part));

  // Half a line, as a kill in the middle of a write leaves it.
  std::ofstream(out.path, std::ios::app) << whole.substr(part.size(), 100);
  const auto rest = run_program("batch --no-timing " + in.quoted() + resume);
  CHECK(rest.exit == 0);
  CHECK_THAT(rest.err, Contains("300 puzzles, ") && Contains(" of them kept, in ") && Contains("300 solved"));
  CHECK((out.text() == whole));
  CHECK(!std::filesystem::exists(out.path + ".progress"));
}

TEST_CASE("resume knows an output that is whole, begins where there is none, and leaves other files alone") {
  const File in("batch-whole.jsonl", lines(0, 100)), other("batch-whole-other.jsonl", lines(1, 101)),
      out("batch-whole-out.jsonl");
  const std::string resume = " --resume -o " + out.quoted();
  CHECK(run_program("batch " + in.quoted() + resume).exit == 0);  // with time_us, which no second run repeats
  const std::string whole = out.text();
  CHECK(split(whole).size() == 100);
  const auto again = run_program("batch " + in.quoted() + resume);
  CHECK(again.exit == 0);
  CHECK_THAT(again.err, Contains("is whole already"));
  const auto wrong = run_program("batch " + other.quoted() + resume);
  CHECK(wrong.exit == 2);
  CHECK_THAT(wrong.err, Contains(".progress is missing, and it is not the whole answer to this input"));
  CHECK((out.text() == whole));
  CHECK(run_program("batch --quiet " + other.quoted() + " -o " + out.quoted()).exit ==
        0);  // without --resume it is written anew
  CHECK((out.text() != whole));
}

TEST_CASE("a stream is answered as it comes") {
  // The second puzzle is sent only after the first was answered.
  const File first("batch-first.jsonl", line(1) + "\n"), second("batch-second.jsonl", line(2) + "\n"),
      answers("batch-answers.jsonl");
  const auto run =
      run_shell(": >" + answers.quoted() + "; { cat " + first.quoted() + "; i=0; while [ ! -s " + answers.quoted() +
                " ] && [ $i -lt 200 ]; do sleep 0.05; i=$((i+1)); done; [ -s " + answers.quoted() + " ] && cat " +
                second.quoted() + "; } | " + "PROGRAM " + batch + "- >" + answers.quoted());
  CHECK(run.exit == 0);
  CHECK(split(answers.text()).size() == 2);
}
