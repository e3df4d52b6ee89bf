// SPDX-License-Identifier: MIT
//
// A batch in parts, each its own process, and `merge`. The bytes are those of one run, whatever the lines, the number
// of parts and the packing. Parts that are missing, damaged or of another batch are reported.
#include <fmt/format.h>

#include <algorithm>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::run_program;
using bankshot::test::run_shell;
using Catch::Contains;

/// A temporary folder that is removed with the object.
struct Folder {
  std::string path =
      (std::filesystem::temp_directory_path() / ("bankshot part " + std::to_string(::getpid()))).string();
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator()(const std::string& name) const { return "\"" + path + "/" + name + "\""; }
  std::string read(const std::string& name) const {
    std::ifstream in(path + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  bool has(const std::string& name) const { return std::filesystem::exists(path + "/" + name); }
};

/// Returns puzzles of very different lengths and lines that are not puzzles; the last line has no line break.
std::string puzzles(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    if (i % 11 == 3)
      out += i % 2 == 0 ? "no puzzle at all\n" : "\n";
    else
      out += R"({"about": ")" + std::string(static_cast<std::size_t>(i % 7 == 0 ? 900 : i % 5), 'x') +
             R"(", "table": "seed", "physics": "rolling", "ball": {"at": [)" + std::to_string(0.5 + 0.002 * i) +
             R"(, 0.4]}, "target": {"point": [1.5, 1.0]}, "cushions": ["top"]})" + "\n";
  }
  out.pop_back();
  return out;
}

const std::string batch = "batch --no-timing --no-robustness --quiet ";

}  // namespace

TEST_CASE("parts of a batch, merged, are the bytes of the batch in one go", "[heavy]") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(160);
  run_shell("gzip -k " + in("p.jsonl"));
  const auto [n, file, suffix] = GENERATE(table<int, std::string, std::string>(
      {{1, "p.jsonl", ""}, {2, "p.jsonl", ""}, {7, "p.jsonl", ""}, {300, "p.jsonl", ""}, {5, "p.jsonl.gz", ".gz"}}));
  INFO(n << " parts of " << file);
  CHECK(run_program(batch + in(file) + " -o " + in("whole.jsonl" + suffix)).exit == 0);
  std::string parts;
  for (int k = n - 1; k >= 0; --k) {
    const std::string name = "part-" + std::to_string(k) + ".jsonl" + suffix;
    const auto run =
        run_program(batch + in(file) + " --part " + std::to_string(k) + "/" + std::to_string(n) + " -o " + in(name));
    REQUIRE(run.exit == 0);
    CHECK(run.err.empty());
    CHECK(in.has(name + ".part"));
    parts += in(name) + " ";
  }
  const auto merged = run_program("merge " + parts + "-o " + in("merged.jsonl" + suffix));
  CHECK_THAT(merged.err, Contains("160 answers of " + std::to_string(n) + " parts"));
  CHECK(merged.exit == 0);
  CHECK((in.read("merged.jsonl" + suffix) == in.read("whole.jsonl" + suffix)));
  for (const auto& entry : std::filesystem::directory_iterator(in.path)) {
    INFO(entry.path());
    CHECK(entry.path().string().find(".partial") == std::string::npos);
    CHECK(entry.path().string().find(".progress") == std::string::npos);
  }
}

TEST_CASE("merge tells what is missing, damaged or of another batch, and writes nothing") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(60);
  std::ofstream(in.path + "/other.jsonl", std::ios::binary) << "x" + puzzles(60);
  const auto make = [&](const std::string& file, int k, int n, const std::string& name, const std::string& flags = "") {
    REQUIRE(run_program(batch + flags + in(file) + " --part " + std::to_string(k) + "/" + std::to_string(n) + " -o " +
                        in(name))
                .exit == 0);
  };
  for (int k = 0; k < 8; ++k) make("p.jsonl", k, 8, std::to_string(k));
  const auto merge = [&](const std::string& names) {
    std::string files;
    for (const char c : names) files += in(std::string(1, c)) + " ";
    const auto run = run_program("merge " + files + "-o " + in("merged"));
    CHECK(in.has("merged") == (run.exit == 0));
    std::filesystem::remove(in.path + "/merged");
    return run.err;
  };
  CHECK_THAT(merge("01234567"), Contains("60 answers of 8 parts"));
  CHECK_THAT(merge("046"), Contains("5 of 8 parts are missing or damaged; make them again with --array=1-3,5,7"));
  CHECK_THAT(merge("001234567"), Contains("are both part 0"));
  std::ofstream(in.path + "/3", std::ios::app) << "{}\n";
  CHECK_THAT(merge("01234567"), Contains("is not what part 3 wrote"));
  CHECK_THAT(merge("0123456"), Contains("--array=3,7"));
  make("other.jsonl", 3, 8, "3");
  CHECK_THAT(merge("01234567"), Contains("they are of different inputs"));
  make("p.jsonl", 3, 8, "3", "--all ");
  CHECK_THAT(merge("01234567"), Contains("other flags"));
  make("p.jsonl", 3, 9, "3");
  CHECK_THAT(merge("01234567"), Contains("one of 9 parts"));
  std::filesystem::remove(in.path + "/3.part");
  CHECK_THAT(merge("01234567"), Contains("3.part is missing, which stands beside a part that is whole"));
  CHECK(run_program(batch + in("p.jsonl") + " --part 3/8 --resume -o " + in("3")).exit == 0);
  CHECK_THAT(merge("01234567"), Contains("60 answers of 8 parts"));
}

TEST_CASE("a packed part that is cut off is damaged, and made again") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(60);
  const std::string make = batch + in("p.jsonl") + " --part 0/1 --resume -o " + in("0.gz");
  REQUIRE(run_program(make).exit == 0);
  std::filesystem::resize_file(in.path + "/0.gz", std::filesystem::file_size(in.path + "/0.gz") / 2);
  const std::string merge = "merge " + in("0.gz") + " -o " + in("merged.gz");
  CHECK_THAT(run_program(merge).err, Contains("make them again with --array=0"));
  REQUIRE(run_program(make).exit == 0);
  CHECK(run_program(merge).exit == 0);
}

TEST_CASE("a part that is there is not made again, and one that was cut off goes on") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(900);
  const std::string command = "batch --no-timing --no-robustness " + in("p.jsonl") + " --part 1/3 -o " + in("b");
  REQUIRE(run_program(command).exit == 0);
  const std::string whole = in.read("b");
  CHECK_THAT(run_program(command + " --resume").err, Contains("is whole already"));
  // The output of another input is not accepted as whole, even if the other input only has one more line.
  std::ofstream(in.path + "/other.jsonl", std::ios::binary) << puzzles(899);
  const std::string first = "batch --no-timing --no-robustness -o " + in("first") + " --part 0/1 --resume ";
  REQUIRE(run_program(first + in("other.jsonl")).exit == 0);
  CHECK_THAT(run_program(first + in("p.jsonl")).err, Contains("900 puzzles"));
  CHECK_THAT(run_program(first + in("p.jsonl")).err, Contains("is whole already"));
  // The state after a kill: some answers, and a journal that says how many of them are valid.
  std::filesystem::remove(in.path + "/b");
  const auto killed = run_shell("(ulimit -f 30; PROGRAM " + command + " --quiet) 2>/dev/null; ls " + in(""));
  CHECK_THAT(killed.out, Contains("b.partial.progress"));
  CHECK_THAT(killed.out, !Contains("b\n"));
  CHECK(run_program(command + " --resume").exit == 0);
  CHECK((in.read("b") == whole));
}

TEST_CASE("a part that runs is not run a second time and, where no lock tells, nothing wrong passes for right") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(3000);
  const std::string timing = GENERATE("--no-timing ", "");
  const std::string command = "batch --no-robustness --quiet " + timing + in("p.jsonl") + " --part 0/1 -o " + in("b");
  const std::string journal = in("b.partial.progress");
  // The first run is stopped once it has written something, like a run on a node that hangs; then a second run begins.
  // On a busy machine the first run may finish before it is stopped; then it is tried again.
  const auto both = [&](const std::string& between) {
    return run_shell(fmt::format(
        R"(for try in 1 2 3 4 5 6 7 8 9; do
             PROGRAM {command} & first=$!
             until [ -s {journal} ] && [ -s {part} ] || [ -e {whole} ]; do :; done
             kill -STOP $first
             [ -e {whole} ] || [ $(wc -l <{part}) -ge 3000 ] || break
             kill -CONT $first; wait; rm -f {whole}
           done
           {between}
           PROGRAM {command} --resume; echo second $?
           kill -CONT $first; wait $first; echo first $?)",
        fmt::arg("command", command), fmt::arg("part", in("b.partial")), fmt::arg("journal", journal),
        fmt::arg("whole", in("b")), fmt::arg("between", between)));
  };
  const auto refused = both("");
  CHECK_THAT(refused.err, Contains("b.partial: another bankshot is writing this file"));
  CHECK_THAT(refused.out, Contains("second 2") && Contains("first 0"));
  const std::string whole = in.read("b");
  CHECK((std::ranges::count(whole, '\n') == 3000));
  std::filesystem::remove(in.path + "/b");
  // The lock of the old journal does not protect the new one. This simulates two machines that share no locks.
  const auto unlocked = both("cp " + journal + " " + in("j") + "; mv " + in("j") + " " + journal);
  INFO(unlocked.out << unlocked.err);
  CHECK_THAT(unlocked.out, Contains("second 0"));
  const std::string merge = "merge " + in("b") + " -o " + in("merged");
  if (timing.empty()) {  // both wrote other bytes
    CHECK_THAT(unlocked.out, Contains("first 2"));
    CHECK_THAT(unlocked.err, Contains("is not what was written to it"));
    CHECK_THAT(run_program(merge).err, Contains("--array=0"));
    CHECK(run_program(command + " --resume").exit == 0);
    CHECK(run_program(merge).exit == 0);
  } else {
    CHECK_THAT(unlocked.out, Contains("first 0"));
    CHECK(run_program(merge).exit == 0);
    CHECK((in.read("merged") == whole));
  }
}

TEST_CASE("answers that a machine took with it when it died are made again") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(900);
  const auto [suffix, part] =
      GENERATE(table<std::string, std::string>({{"", " --part 0/1"}, {".gz", " --part 0/1"}, {"", ""}}));
  const std::string name = "b" + suffix, grows = part.empty() ? name : "b.partial" + suffix;
  const std::string command = "batch --no-timing --no-robustness --quiet " + in("p.jsonl") + part + " -o " + in(name);
  REQUIRE(run_program(command).exit == 0);
  const std::string whole = in.read(name);
  std::filesystem::remove(in.path + "/" + name);
  const int blocks = static_cast<int>(whole.size() / 2 / 512);
  run_shell("ulimit -f " + std::to_string(blocks) + "; PROGRAM " + command);
  REQUIRE(in.has(grows + ".progress"));
  // The file has its full length, but one of its blocks never reached the disk; the journal did.
  run_shell("dd if=/dev/zero of=" + in(grows) + " bs=512 count=1 seek=" + std::to_string(blocks / 2) + " conv=notrunc");
  CHECK(run_program(command + " --resume").exit == 0);
  CHECK((in.read(name) == whole));
}

TEST_CASE("which part a process is, schedulers tell") {
  const Folder in;
  std::ofstream(in.path + "/p.jsonl", std::ios::binary) << puzzles(20);
  const auto part = [&](const std::string& variables, const std::string& option = "--part") {
    const auto run = run_shell(variables + " PROGRAM " + batch + in("p.jsonl") + " -o " + in("x") + " " + option +
                               " 2>&1; cat " + in("x.part") + " 2>/dev/null; rm -f " + in("x.part"));
    return run.out;
  };
  CHECK_THAT(part("SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_COUNT=4 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=3"),
             Contains("\"part\":2") && Contains("\"of\":4"));
  CHECK_THAT(part("SLURM_ARRAY_TASK_ID=17 SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=3 SLURM_ARRAY_TASK_MAX=17"),
             Contains("--part 17/N"));
  CHECK_THAT(part("OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=3"), Contains("\"part\":1") && Contains("\"of\":3"));
  CHECK_THAT(part("PMI_RANK=0 PMI_SIZE=2"), Contains("\"part\":0") && Contains("\"of\":2"));
  CHECK_THAT(part(""), Contains("no scheduler says which part this is"));
  CHECK_THAT(part("", "--part 4/4"), Contains("K is from 0 to N - 1"));
  CHECK_THAT(part("", "--part 1"), Contains("is not K/N"));
  CHECK_THAT(run_shell("echo {} | PROGRAM batch - --part 0/2 -o " + in("y") + " 2>&1").out,
             Contains("only a file has parts"));
  CHECK_THAT(run_program("batch " + in("p.jsonl") + " --part 0/2").err, Contains("needs a file of its own"));
}
