// SPDX-License-Identifier: MIT
//
// The parts of `batch`: lines in chunks and in parts of a file, the output and what is kept of it, the journal of a
// batch, the record of a part, counts, and the pipeline from lines to answers.
#include "app/batch/journal.hpp"
#include "app/batch/lines.hpp"
#include "app/batch/output.hpp"
#include "app/batch/part_record.hpp"
#include "app/batch/pipeline.hpp"
#include "app/batch/tally.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/files.hpp"
#include "app/gzip.hpp"
#include "app/interrupt.hpp"
#include "app/random_text.hpp"
#include "app/scratch_file.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app;
using namespace bankshot::app::batch;
using Catch::Contains;
using test::random_text;
using test::ScratchFile;
using test::split;
using Json = nlohmann::json;

namespace {

/// Returns the CRC-32 of a text bit by bit, as its polynomial defines it.
std::uint32_t crc_of(std::string_view text) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

/// The lines that a reader gave, and where each chunk ended.
struct Read {
  std::vector<std::string> lines;
  std::vector<ReadMark> ends;
};

Read read_to_end(LineReader& in) {
  Read out;
  const long before = in.mark().lines;
  for (Lines chunk; in.next(chunk);) {
    CHECK(chunk.lines.size() <= LineReader::lines_a_chunk);
    for (std::size_t i = 0; i < chunk.lines.size(); ++i) {
      out.lines.emplace_back(chunk.line(i));
      if (chunk.number(i) != before + static_cast<long>(out.lines.size()))
        FAIL("line " << out.lines.size() << " has the number " << chunk.number(i));
    }
    CHECK(chunk.after == in.mark());
    out.ends.push_back(chunk.after);
  }
  return out;
}

/// An input file with a text, packed if its name says so.
ScratchFile& filled(ScratchFile& file, const std::string& text) {
  file.write(is_packed(file.path) ? gzipped(text) : text);
  return file;
}

/// The variables by which schedulers name parts, unset while it lives.
class NoScheduler {
 public:
  NoScheduler() { clear(); }
  NoScheduler(const NoScheduler&) = delete;
  NoScheduler& operator=(const NoScheduler&) = delete;
  ~NoScheduler() { clear(); }
  static void clear() {
    for (const char* name :
         {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
          "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE"})
      unsetenv(name);
  }
  static void set(const std::map<std::string, std::string>& variables) {
    clear();
    for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
  }
};

Tally tally_of(long solved, long no_shot, long budget, long invalid, long first_invalid) {
  Tally t;
  t.solved = solved, t.no_shot = no_shot, t.budget = budget, t.invalid = invalid, t.first_invalid = first_invalid;
  return t;
}

Journal::Mark mark_at(const std::string& input, long lines, const std::string& output) {
  Journal::Mark m;
  m.read = {lines, static_cast<long>(input.size()), crc_of(input)};
  m.written = static_cast<long>(output.size());
  m.crc = crc_of(output);
  m.tally = tally_of(lines, 0, 0, 0, 0);
  m.tally.worst_miss = 1.0 / 3e9;
  m.tally.simulations = 123456789012;
  return m;
}

std::string puzzle(double x, const char* more = "") {
  return R"({"table": "seed", "physics": "rolling", "ball": {"at": [)" + std::to_string(x) +
         R"(, 0.4]}, "target": {"point": [1.5, 1.0]}, "cushions": ["top"])" + more + "}";
}

/// Returns the answers of a batch to the lines of `input`.
std::string ran(const std::string& input, const service::SolveFlags& flags, int threads) {
  ScratchFile in("pipeline.jsonl"), out("answers.jsonl");
  in.write(input);
  LineReader reader(in.path, true);
  Output output(out.path);
  output.cut(0);
  batch::Progress progress(0, -1, false);
  Batch b{reader, output, nullptr, flags, threads, progress, {}};
  run_pipeline(b);
  output.finish();
  return out.text();
}

}  // namespace

TEST_CASE("a checksum is the CRC-32, and may be continued from any place") {
  constexpr std::uint64_t seed = 1;
  Random draw(seed);
  CHECK(checksum(0, "123456789", 9) == 0xcbf43926);  // the check value that catalogues of CRCs give
  for (int i = 0; i < 50; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = random_text(draw, 20);
    const auto cut = static_cast<std::size_t>(draw.uniform(0, static_cast<double>(text.size())));
    const std::uint32_t before = checksum(0, text.data(), cut);
    CHECK(before == crc_of(text.substr(0, cut)));
    CHECK(checksum(before, text.data() + cut, text.size() - cut) == crc_of(text));
  }
}

TEST_CASE("the lines of a file come in order, and a mark says how many bytes they took") {
  constexpr std::uint64_t seed = 2;
  Random draw(seed);
  for (int i = 0; i < 12; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = i == 0 ? "" : random_text(draw, draw.integer(1, 400));
    ScratchFile plain("lines.jsonl"), packed("lines.jsonl.gz");
    LineReader in(filled(plain, text).path, true), unpacks(filled(packed, text).path, true);
    const Read read = read_to_end(in), same = read_to_end(unpacks);
    CHECK(read.lines == split(text));
    CHECK(in.mark() == ReadMark{static_cast<long>(split(text).size()), static_cast<long>(text.size()), crc_of(text)});
    CHECK(same.lines == read.lines);
    CHECK(same.ends == read.ends);  // chunks end at the same lines, packed or not
    CHECK(in.share() == (text.empty() ? -1 : 1));
    // Every mark can be found again, and then the rest is read.
    for (const ReadMark& mark : read.ends) {
      LineReader again(plain.path, true);
      REQUIRE(again.skip(mark));
      CHECK(again.mark() == mark);
      const Read rest = read_to_end(again);
      CHECK(rest.lines == std::vector(read.lines.begin() + mark.lines, read.lines.end()));
    }
  }
}

TEST_CASE("an input that has changed before a mark is noticed") {
  ScratchFile file("changed.jsonl");
  LineReader in(filled(file, "one\ntwo\nthree\n").path, true);
  Lines lines;
  REQUIRE(in.next(lines));
  const ReadMark mark = in.mark();
  CHECK(LineReader(file.path, true).skip(mark));
  CHECK(!LineReader(filled(file, "one\ntoo\nthree\n").path, true).skip(mark));
  CHECK(!LineReader(filled(file, "one\ntwo\n").path, true).skip(mark));
}

TEST_CASE("each line is in exactly one part, and the end of a part is where the next one begins") {
  constexpr std::uint64_t seed = 3;
  Random draw(seed);
  for (int i = 0; i < 12; ++i) {
    const std::string text = random_text(draw, draw.integer(1, 300));
    const long n = i % 4 == 0 ? 1 : i % 4 == 1 ? draw.integer(2, 5) : draw.integer(5, 100);
    INFO("draw " << i << " of seed " << seed << ", " << n << " parts");
    ScratchFile file(i % 3 == 2 ? "parts.jsonl.gz" : "parts.jsonl");
    filled(file, text);
    std::vector<std::string> lines;
    ReadMark end;
    for (long k = 0; k < n; ++k) {
      LineReader in(file.path, true, {k, n});
      if (!(in.begun() == end)) FAIL("part " << k << " begins at byte " << in.begun().bytes << ", not " << end.bytes);
      const Read part = read_to_end(in);
      lines.insert(lines.end(), part.lines.begin(), part.lines.end());
      end = in.mark();
    }
    CHECK(lines == split(text));
    CHECK(end == ReadMark{static_cast<long>(lines.size()), static_cast<long>(text.size()), crc_of(text)});
  }
}

TEST_CASE("parts of lines of one length hold nearly equal numbers of lines") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "12345678\n";
  ScratchFile file("equal.jsonl");
  filled(file, text);
  for (const long n : {2L, 3L, 7L, 64L})
    for (long k = 0; k < n; ++k) {
      INFO("part " << k << " of " << n);
      LineReader in(file.path, true, {k, n});
      CHECK(std::abs(static_cast<double>(read_to_end(in).lines.size()) - 1000.0 / static_cast<double>(n)) <= 1);
    }
}

TEST_CASE("only the beginning of a line that is too long is kept, and the next line is whole") {
  ScratchFile file("long.jsonl");
  const std::string limit(LineReader::longest_line, 'a'), longer = limit + "b";
  LineReader in(filled(file, limit + "\n" + longer + "\nc\n").path, true);
  std::vector<std::pair<std::size_t, bool>> seen;
  for (Lines chunk; in.next(chunk);)
    for (std::size_t i = 0; i < chunk.lines.size(); ++i)
      seen.emplace_back(chunk.line(i).size(), chunk.lines[i].too_long);
  CHECK(seen == std::vector<std::pair<std::size_t, bool>>{{limit.size(), false}, {limit.size(), true}, {1, false}});
  CHECK(in.mark().bytes == static_cast<long>(limit.size() + longer.size() + 4));
}

TEST_CASE("a file is known by its length and its end, and by itself") {
  ScratchFile one("one.jsonl"), other("other.jsonl");
  const LineReader a(filled(one, "abc\n").path, true), b(filled(other, "abd\n").path, true);
  CHECK_THAT(a.identity(), Contains("4 bytes"));
  CHECK(a.identity() == LineReader(one.path, true).identity());
  CHECK(a.identity() != b.identity());
  const Output same(one.path), another(other.path);
  CHECK(a.same_file(same.descriptor()));
  CHECK(!a.same_file(another.descriptor()));
}

TEST_CASE("what cannot be read is told by its name, after the lines before it") {
  CHECK_THROWS_WITH(LineReader("/no such folder/x", true), Contains("/no such folder/x: cannot be read"));
  CHECK_THROWS_WITH(LineReader("/dev/null", true, {0, 2}), Contains("only a file has parts"));
  ScratchFile file("cut.jsonl.gz");
  std::string text;
  Random draw(4);
  for (int i = 0; i < 20000; ++i) text += std::to_string(draw.uniform(0, 1)) + "\n";
  const std::string packed = gzipped(text);
  file.write(packed.substr(0, packed.size() / 2));
  LineReader in(file.path, true);
  std::vector<std::string> lines;
  std::string why;
  try {
    for (Lines chunk; in.next(chunk);)
      for (std::size_t i = 0; i < chunk.lines.size(); ++i) lines.emplace_back(chunk.line(i));
  } catch (const FileError& e) {
    why = e.what();
  }
  CHECK_THAT(why, Contains("the compressed data end too early"));
  CHECK(lines.size() > 1000);
  const std::vector<std::string> all = split(text);
  REQUIRE(lines.size() < all.size());
  CHECK(lines == std::vector(all.begin(), all.begin() + static_cast<long>(lines.size())));
}

TEST_CASE("no line is read once the program is interrupted") {
  ScratchFile file("interrupted.jsonl");
  filled(file, "one\ntwo\n");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const Interrupts interrupts;
    LineReader in(file.path, true);
    raise(SIGINT);
    Lines lines;
    _exit(in.next(lines) ? 1 : 0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("an output is written after what a cut keeps of it") {
  const ScratchFile file("out.jsonl");
  file.write("0123456789");
  Output out(file.path);
  CHECK(out.regular());
  CHECK(!out.gzip());
  CHECK(out.name() == file.path);
  CHECK(out.size() == 10);
  CHECK(file.text() == "0123456789");  // opening changes nothing
  out.cut(4, crc_of("0123"));
  out.write("ab");
  out.write("");
  out.write("c");
  CHECK(out.written() == 7);
  CHECK(out.crc() == crc_of("0123abc"));
  out.cut_quietly(6);
  CHECK(out.size() == 6);
  out.finish();
  CHECK(file.text() == "0123ab");
  CHECK_THROWS_AS(Output("/no such folder/x"), WriteError);
  CHECK(Output("-").name() == "standard output");
  CHECK(!Output("-").regular());
  const ScratchFile packed("out.jsonl.gz");
  CHECK(Output(packed.path).gzip());
}

TEST_CASE("a device that is full refuses what is written to it") {
  if (!std::filesystem::exists("/dev/full")) return;
  Output out("/dev/full");
  CHECK(!out.regular());
  CHECK_THROWS_WITH(out.write("x"), Contains("/dev/full: cannot be written: No space left"));
}

TEST_CASE("what is kept of a file is what its checksums say, piece by piece") {
  const ScratchFile file("kept.jsonl");
  const std::string text(200000, 'k');  // more than one piece
  file.write(text + "end");
  Kept kept(file.path);
  CHECK(kept.holds(0, 0));
  CHECK(kept.holds(5, crc_of("kkkkk")));
  CHECK(kept.holds(200000, crc_of(text)));
  CHECK(!kept.at_end());
  CHECK(!Kept(file.path).holds(200000, crc_of(text) + 1));
  CHECK(kept.holds(200003, crc_of(text + "end")));
  CHECK(kept.at_end());
  CHECK(!kept.holds(200004, crc_of(text + "end")));
  CHECK(!Kept("/no such folder/x").holds(1, 0));
}

TEST_CASE("a journal remembers the last mark whose answers are there") {
  const ScratchFile out("answers.jsonl"), file("answers.jsonl.progress");
  REQUIRE(Journal::path_for(out.path) == file.path);
  const std::vector<Journal::Mark> marks{mark_at("a\n", 1, "A\n"), mark_at("a\nb\n", 2, "A\nB\n"),
                                         mark_at("a\nb\nc\n", 3, "A\nB\nC\n")};
  {
    Journal journal(out.path, "--all", "6 bytes");
    CHECK(!journal.last(out.path));
    journal.begin();
    for (const Journal::Mark& m : marks) journal.add(m);
  }
  const auto last = [&](const std::string& answers) {
    out.write(answers);
    return Journal(out.path, "--all", "6 bytes").last(out.path);
  };
  const auto whole = last("A\nB\nC\n");
  REQUIRE(whole);
  CHECK(whole->read == marks[2].read);
  CHECK(whole->written == marks[2].written);
  CHECK(whole->crc == marks[2].crc);
  CHECK(whole->tally.lines() == 3);
  CHECK(whole->tally.worst_miss == marks[2].tally.worst_miss);  // to the last bit
  CHECK(whole->tally.simulations == marks[2].tally.simulations);
  CHECK(last("A\nB\nC")->read == marks[1].read);            // an answer that was cut off
  CHECK(last("A\nB\nC\nand more")->read == marks[2].read);  // an answer without a mark
  CHECK(last("A\nX\nC\n")->read == marks[0].read);          // another program wrote here
  CHECK(!last(""));

  SECTION("a mark that was cut off does not count") {
    const std::string text = file.text();
    file.write(text.substr(0, text.size() - 1));
    CHECK(last("A\nB\nC\n")->read == marks[1].read);
  }
  SECTION("the journal goes on after a mark, and drops those behind it") {
    out.write("A\nB\nC\n");
    Journal(out.path, "--all", "6 bytes").go_on(marks[0]);
    CHECK(last("A\nB\nC\n")->read == marks[0].read);
    Journal journal(out.path, "--all", "6 bytes");
    journal.go_on(marks[0]);
    journal.add(marks[2]);
    CHECK_THROWS_WITH(Journal(out.path, "--all", "6 bytes"), Contains("another bankshot is writing this file"));
  }
  SECTION("a journal is removed when the batch is done") {
    Journal(out.path, "--all", "6 bytes").remove();
    CHECK(!std::filesystem::exists(file.path));
  }
}

TEST_CASE("a batch is resumed only by the same flags, input and version") {
  const ScratchFile out("same.jsonl"), file("same.jsonl.progress");
  const auto check = [&](const std::string& flags, const std::string& input) {
    Journal(out.path, flags, input).check_same();
  };
  CHECK_NOTHROW(check("--all", "6 bytes"));  // nothing was begun
  Journal(out.path, "--all", "6 bytes").begin();
  CHECK_NOTHROW(check("--all", "6 bytes"));
  CHECK_NOTHROW(check("--all", ""));  // a stream cannot be told from another
  CHECK_THROWS_WITH(check("--first", "6 bytes"), Contains("other flags: --all; now they are --first"));
  CHECK_THROWS_WITH(check("--all", "7 bytes"), Contains("another input: 6 bytes; now it has 7 bytes"));
  const std::string text = file.text();
  file.write("bankshot 0.0.0" + text.substr(text.find('\n')));
  CHECK_THROWS_WITH(check("--all", "6 bytes"), Contains("another version"));
}

TEST_CASE("the record of a part is read back as it was written") {
  const ScratchFile out("part.jsonl"), file("part.jsonl.part");
  REQUIRE(PartRecord::path_for(out.path) == file.path);
  CHECK(!read_part(out.path));
  const std::string answers = "A\nB\n";
  out.write(answers);
  const PartRecord record{
      {3, 8}, "--all --player \"pro\"", {1, 10, 0xffffffff}, {3, 5000000000, 0x80000000}, {2, 4, crc_of(answers)}, 1};
  write_part(out.path, record);
  CHECK(!std::filesystem::exists(file.path + ".partial"));
  const auto read = read_part(out.path);
  REQUIRE(read);
  CHECK(read->part == record.part);
  CHECK(read->flags == record.flags);
  CHECK(read->from == record.from);
  CHECK(read->to == record.to);
  CHECK(read->output == record.output);
  CHECK(read->invalid == record.invalid);

  CHECK(is_whole(out.path, record));
  PartRecord more = record;
  more.to.lines = 4;  // an answer is missing
  CHECK(!is_whole(out.path, more));
  out.write("A\nC\n");
  CHECK(!is_whole(out.path, record));
  std::filesystem::remove(out.path);
  CHECK(!is_whole(out.path, record));

  const std::string text = file.text();
  file.write(text.substr(0, text.size() / 2));
  CHECK_THROWS_WITH(read_part(out.path), Contains(file.path));
  Json json = Json::parse(text);
  json["bankshot"] = "0.0.0";
  file.write(json.dump());
  CHECK_THROWS_WITH(read_part(out.path), Contains("another version"));
  json = Json::parse(text);
  json.erase("to");
  file.write(json.dump());
  CHECK_THROWS_WITH(read_part(out.path), Contains("/to"));
}

TEST_CASE("a file is measured by its unpacked bytes") {
  constexpr std::uint64_t seed = 5;
  Random draw(seed);
  for (int i = 0; i < 5; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = random_text(draw, 100) + "\n";
    ScratchFile plain("measured.jsonl"), packed("measured.jsonl.gz");
    const ReadMark mark{static_cast<long>(std::count(text.begin(), text.end(), '\n')), static_cast<long>(text.size()),
                        crc_of(text)};
    CHECK(measured(filled(plain, text).path) == mark);
    CHECK(measured(filled(packed, text).path) == mark);
    const PartRecord record{{0, 1}, "", {}, {mark.lines, 0, 0}, mark, 0};
    CHECK(is_whole(packed.path, record));
    const std::string bytes = packed.text();
    packed.write(bytes.substr(0, bytes.size() - 9));
    CHECK(!is_whole(packed.path, record));  // and throws nothing
  }
}

TEST_CASE("a finished file takes its name in one step") {
  const ScratchFile from("finished.partial"), to("finished");
  from.write("new");
  to.write("old");
  put_in_place(from.path, to.path);
  CHECK(to.text() == "new");
  CHECK(!std::filesystem::exists(from.path));
  CHECK_THROWS_AS(put_in_place(from.path, to.path), WriteError);
  CHECK(to.text() == "new");
}

TEST_CASE("a part is K/N, with K from 0 to N - 1") {
  CHECK(part_of("0/1") == Part{0, 1});
  CHECK(part_of("63/64") == Part{63, 64});
  CHECK(part_of("999999/1000000") == Part{999999, 1000000});
  for (const char* text : {"1", "/", "1/", "/2", "a/b", "1/2/3", "1 /2", "+1/2", "1.0/2"}) {
    INFO(text);
    CHECK_THROWS_WITH(part_of(text), Contains("is not K/N"));
  }
  for (const char* text : {"1/1", "-1/2", "0/0", "0/-1", "0/1000001", "5/3"}) {
    INFO(text);
    CHECK_THROWS_WITH(part_of(text), Contains("is no part"));
  }
}

TEST_CASE("without K/N a part is the one that the scheduler names") {
  const NoScheduler none;
  CHECK_THROWS_WITH(part_of(""), Contains("no scheduler says"));
  const auto named = [](const std::map<std::string, std::string>& variables) {
    NoScheduler::set(variables);
    return part_of("");
  };
  CHECK(named({{"PMI_RANK", "2"}, {"PMI_SIZE", "5"}}) == Part{2, 5});
  CHECK(named({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "3"}}) == Part{0, 3});
  CHECK(named({{"SLURM_ARRAY_TASK_ID", "4"}, {"SLURM_ARRAY_TASK_COUNT", "6"}}) == Part{4, 6});
  CHECK(named({{"SLURM_ARRAY_TASK_ID", "4"},
               {"SLURM_ARRAY_TASK_COUNT", "6"},
               {"SLURM_ARRAY_TASK_MIN", "0"},
               {"SLURM_ARRAY_TASK_MAX", "5"},
               {"PMI_RANK", "0"},
               {"PMI_SIZE", "2"}}) == Part{4, 6});
  // An array from 1, or with gaps, does not say which parts there are.
  CHECK_THROWS_WITH(named({{"SLURM_ARRAY_TASK_ID", "4"},
                           {"SLURM_ARRAY_TASK_COUNT", "6"},
                           {"SLURM_ARRAY_TASK_MIN", "1"},
                           {"SLURM_ARRAY_TASK_MAX", "6"}}),
                    Contains("--part 4/N"));
  CHECK_THROWS_WITH(named({{"PMI_RANK", "two"}, {"PMI_SIZE", "5"}}), Contains("no scheduler says"));
  CHECK_THROWS_WITH(named({{"PMI_RANK", "5"}, {"PMI_SIZE", "5"}}), Contains("is no part"));
  CHECK(part_of("1/2") == Part{1, 2});  // what is typed counts before the scheduler
}

TEST_CASE("a tally counts answers by status, and solved ones by how near they come to the centre") {
  Puzzle p;
  p.table = rectangle_table(3, 4);  // a diagonal of 5 m
  const double exact = tolerance::exact_miss * 5;
  const auto answer = [](Status status, double miss = 0) {
    Answer a;
    a.status = status;
    a.simulations = 10;
    if (status == Status::solved) a.shots.emplace_back().verification.miss = miss;
    return a;
  };
  Tally t;
  t.add(p, answer(Status::solved, exact / 2));
  t.add(p, answer(Status::solved, exact / 4));
  t.add(p, answer(Status::solved, 2 * exact));
  t.add(p, answer(Status::no_shot));
  t.add(p, answer(Status::budget));
  t.add(p, answer(Status::budget));
  t.add_invalid(7);
  t.add_invalid(9);
  CHECK((t.solved == 3 && t.no_shot == 1 && t.budget == 2 && t.invalid == 2));
  CHECK(t.lines() == 8);
  CHECK(t.first_invalid == 7);
  CHECK(t.beside == 1);
  CHECK(t.worst_miss == exact / 2);
  CHECK(t.simulations == 60);

  // The sum of the tallies of two runs is that of one run.
  Tally first = tally_of(5, 4, 3, 0, 0);
  first.worst_miss = exact;
  first.add(t);
  CHECK((first.solved == 8 && first.no_shot == 5 && first.budget == 5 && first.invalid == 2));
  CHECK(first.first_invalid == 7);
  CHECK((first.worst_miss == exact && first.beside == 1 && first.simulations == 60));
  t.add(tally_of(0, 0, 0, 1, 20));
  CHECK(t.first_invalid == 7);
}

TEST_CASE("the summary tells what there is to tell") {
  const batch::Progress progress(0, -1, false);
  Tally t = tally_of(1, 0, 0, 0, 0);
  t.worst_miss = 1.25e-12;
  CHECK_THAT(closing_line(t, 0, progress), Catch::StartsWith("1 puzzle in ") &&
                                               Contains(": 1 solved, 0 no-shot, 0 invalid; worst miss 1.2e-12 m\n") &&
                                               !Contains("kept") && !Contains("budget") && !Contains("beside"));
  t = tally_of(1200000, 30, 4, 5, 17);
  t.beside = 6;
  CHECK_THAT(closing_line(t, 1000, progress),
             Catch::StartsWith("1,200,039 puzzles, 1,000 of them kept, in ") &&
                 Contains("1,200,000 solved, 30 no-shot, 4 out of budget, 5 invalid (the first on line 17); ") &&
                 Contains("6 beside the target's centre\n"));
  CHECK(progress.rate(t) > 0);
  CHECK(progress.seconds() >= 0);
}

TEST_CASE("long numbers have a comma after every third digit from the right") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(123456) == "123,456");
  CHECK(grouped(1234567) == "1,234,567");
}

TEST_CASE("the costs of a batch add up, each in microseconds of a puzzle") {
  const Cost one{1, 2, 3, 4, 5, 6, 7};
  Cost c{};
  c.add(one);
  c.add(one);
  const batch::Progress progress(0, -1, false);
  const std::string csv = cost_csv(c, tally_of(3, 1, 0, 0, 0), 2, progress);
  std::istringstream in(csv);
  std::vector<std::string> names, values;
  std::string header, row;
  REQUIRE((std::getline(in, header) && std::getline(in, row)));
  std::istringstream columns(header), numbers(row);
  for (std::string s; std::getline(columns, s, ',');) names.push_back(s);
  for (std::string s; std::getline(numbers, s, ',');) values.push_back(s);
  REQUIRE(names.size() == values.size());
  const auto value = [&](const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    REQUIRE(at != names.end());
    return std::stod(values[static_cast<std::size_t>(at - names.begin())]);
  };
  CHECK(value("puzzles") == 2);  // four less two of an earlier run
  CHECK(value("read_us") == 1e6);
  CHECK(value("write_us") == 7e6);
  CHECK(value("cpu_us_each") == 1e6 * (1 + 2 + 3 + 4 + 5 + 6 + 7));
  CHECK(value("peak_mb") > 1);
}

TEST_CASE("the pipeline answers every line in order, whatever the number of threads") {
  std::string input;
  for (int i = 0; i < 200; ++i) input += i % 50 == 7 ? "no puzzle\n" : puzzle(0.5 + 0.002 * i) + "\n";
  input += "\n" + puzzle(0.7, R"(, "id": "last")");  // without a line break
  service::SolveFlags flags;
  flags.no_timing = flags.no_robustness = true;
  ScratchFile file("same-lines.jsonl");
  LineReader in(filled(file, input).path, true);
  std::string expected;
  for (Lines lines; in.next(lines);)
    for (std::size_t i = 0; i < lines.lines.size(); ++i) expected += answer_line(lines, i, flags) + "\n";
  CHECK(ran(input, flags, 1) == expected);
  CHECK(ran(input, flags, 3) == expected);
  const std::vector<std::string> answers = split(expected);
  REQUIRE(answers.size() == 202);
  long solved = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Json answer = Json::parse(answers[i]);
    const bool bad = i == 200 || (i < 200 && i % 50 == 7);
    if ((answer["status"] == "invalid") != bad) FAIL("line " << i + 1 << ": " << answers[i]);
    solved += answer["status"] == "solved";
  }
  CHECK(solved > 150);
  CHECK(Json::parse(answers.back())["id"] == "last");
  CHECK_THAT(answers[7], Contains("line 8"));
  CHECK_THAT(answers[200], Contains("blank line"));
}

TEST_CASE("the pipeline says how far it came, counts its answers, and leaves a mark for each chunk") {
  std::string input;
  for (int i = 0; i < 150; ++i) input += i == 4 ? "{}\n" : puzzle(0.5 + 0.002 * i) + "\n";
  service::SolveFlags flags;
  flags.no_timing = flags.no_robustness = true;
  ScratchFile in("marked.jsonl"), out("marked.out");
  LineReader reader(filled(in, input).path, true);
  Output output(out.path);
  output.cut(0);
  Journal journal(out.path, flags.words(), reader.identity());
  journal.begin();
  batch::Progress progress(0, -1, false);
  Cost cost;
  Batch b{reader, output, &journal, flags, 2, progress, {}, &cost};
  run_pipeline(b);
  const std::string answers = out.text();
  CHECK(b.at.read == ReadMark{150, static_cast<long>(input.size()), crc_of(input)});
  CHECK(b.at.written == static_cast<long>(answers.size()));
  CHECK(b.at.crc == crc_of(answers));
  CHECK(b.at.tally.lines() == 150);
  CHECK(b.at.tally.first_invalid == 5);
  CHECK(b.at.tally.simulations > 149);
  CHECK((cost.parse > 0 && cost.search > 0 && cost.format > 0));
  const ScratchFile left("marked.out.progress");
  const auto lines = static_cast<long>(split(left.text()).size());
  CHECK(lines == 3 + (150 + 63) / 64);
}

TEST_CASE("an output that fails ends the pipeline with its error") {
  if (!std::filesystem::exists("/dev/full")) return;
  ScratchFile in("fails.jsonl");
  std::string input;
  for (int i = 0; i < 300; ++i) input += "no puzzle\n";
  LineReader reader(filled(in, input).path, true);
  Output output("/dev/full");
  batch::Progress progress(0, -1, false);
  const service::SolveFlags flags;
  Batch b{reader, output, nullptr, flags, 2, progress, {}};
  CHECK_THROWS_AS(run_pipeline(b), WriteError);
  CHECK(b.at.tally.lines() == 0);
}

TEST_CASE("a packed output is the packed answers, chunk by chunk") {
  std::string input;
  for (int i = 0; i < 100; ++i) input += puzzle(0.5 + 0.002 * i) + "\n";
  service::SolveFlags flags;
  flags.no_timing = flags.no_robustness = true;
  ScratchFile in("packs.jsonl"), out("packs.jsonl.gz");
  LineReader reader(filled(in, input).path, true);
  Output output(out.path);
  output.cut(0);
  batch::Progress progress(0, -1, false);
  Batch b{reader, output, nullptr, flags, 2, progress, {}};
  run_pipeline(b);
  output.finish();
  CHECK(read_file(out.path) == ran(input, flags, 1));
}
