// SPDX-License-Identifier: MIT
//
// Parts that the commands share before they begin to work: gzip files, lines of files, signals, processor time, and
// checks of file names.
#include "app/clock.hpp"
#include "app/gzip.hpp"
#include "app/interrupt.hpp"
#include "app/line_file.hpp"
#include "app/option_checks.hpp"
#include "app/read_each.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/random_text.hpp"
#include "app/scratch_file.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::app;
using Catch::Contains;
using test::random_text;
using test::ScratchFile;
using test::split;

namespace {

constexpr std::size_t piece_size = 256 << 10;  // bytes that a ByteReader reads at once

/// Unpacks one gzip member by zlib alone.
std::string unpacked(const std::string& packed, std::size_t size) {
  std::string out(size + 1, '\0');
  z_stream z{};
  REQUIRE(inflateInit2(&z, MAX_WBITS + 16) == Z_OK);  // 16: with a gzip header
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  z.avail_in = static_cast<uInt>(packed.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  CHECK(inflate(&z, Z_FINISH) == Z_STREAM_END);
  CHECK(z.avail_in == 0);
  out.resize(z.total_out);
  inflateEnd(&z);
  return out;
}

std::string read_all(const std::string& path) {
  ByteReader in(path);
  std::string out;
  for (std::string_view piece; !(piece = in.next()).empty();) {
    CHECK(piece.size() <= piece_size);
    out += piece;
  }
  return out;
}

std::vector<std::string> lines_of(const std::string& path) {
  LineFile in(path);
  std::vector<std::string> out;
  for (std::string line; in.next(line);) {
    out.push_back(line);
    if (in.number != static_cast<long>(out.size())) FAIL("line " << out.size() << " has the number " << in.number);
  }
  return out;
}

/// Runs `f` in a process of its own, since a signal is noted for good, and returns how the process ended.
int in_child(const std::function<int()>& f) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(f());
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return status;
}

/// Takes what is written to standard error while it lives.
class Overheard {
 public:
  Overheard() : before_(std::cerr.rdbuf(text_.rdbuf())) {}
  Overheard(const Overheard&) = delete;
  Overheard& operator=(const Overheard&) = delete;
  ~Overheard() { std::cerr.rdbuf(before_); }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* before_;
};

}  // namespace

TEST_CASE("a gzip file is known by its suffix alone") {
  CHECK(is_packed("shots.jsonl.gz"));
  CHECK(!is_packed("shots.gzip"));
  CHECK(!is_packed("gz"));
  CHECK(unpacked_name("table.csv.gz") == "table.csv");
  CHECK(unpacked_name("table.csv") == "table.csv");
  CHECK(unpacked_name(".gz").empty());
}

TEST_CASE("a packed text is unpacked to the same bytes, and equal texts have equal bytes") {
  constexpr std::uint64_t seed = 1;
  Random draw(seed);
  for (int i = 0; i < 20; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = i == 0 ? "" : random_text(draw, 100), packed = gzipped(text);
    CHECK(unpacked(packed, text.size()) == text);
    CHECK(gzipped(text) == packed);
  }
}

TEST_CASE("a file is read in pieces to its end, packed in one or more members or not packed") {
  constexpr std::uint64_t seed = 2;
  Random draw(seed);
  for (int i = 0; i < 8; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = random_text(draw, 100), more = random_text(draw, 50);
    const ScratchFile plain("bytes.txt"), packed("bytes.gz");
    plain.write(text + more);
    packed.write(gzipped(text) + gzipped(more));
    CHECK(read_all(plain.path) == text + more);
    CHECK(read_all(packed.path) == text + more);
  }
  const ScratchFile empty("empty.gz");
  empty.write("");
  CHECK(read_all(empty.path).empty());
}

TEST_CASE("a file that is missing, a folder or cut off cannot be read, and its name is told") {
  CHECK_THROWS_WITH(read_all("/no such folder/file"), Contains("/no such folder/file: cannot be read: No such file"));
  CHECK_THROWS_AS(read_all(std::filesystem::temp_directory_path().string()), FileError);
  const ScratchFile file("cut.gz");
  std::string noise;
  Random draw(3);
  for (int i = 0; i < 100000; ++i) noise += static_cast<char>(draw.integer(0, 127));
  const std::string packed = gzipped(noise);
  for (const std::size_t kept : {std::size_t{5}, std::size_t{400}, packed.size() / 2, packed.size() - 1}) {
    INFO(kept << " of " << packed.size() << " bytes");
    file.write(packed.substr(0, kept));
    CHECK_THROWS_WITH(read_all(file.path), Contains("cannot be read: it is no whole gzip file"));
  }
}

TEST_CASE("the lines of a file are those between its line breaks, numbered from 1") {
  const ScratchFile file("lines.txt");
  const auto of = [&](const std::string& text) {
    file.write(text);
    return lines_of(file.path);
  };
  using Lines = std::vector<std::string>;
  CHECK(of("").empty());
  CHECK(of("a") == Lines{"a"});
  CHECK(of("a\n") == Lines{"a"});
  CHECK(of("\n\n") == Lines{"", ""});
  CHECK(of("a\r\n\nb") == Lines{"a\r", "", "b"});
  // A line break at the end of a piece, and one just after it.
  const std::string long_line(piece_size - 1, 'x');
  CHECK(of(long_line + "\n") == Lines{long_line});
  CHECK(of(long_line + "\nb") == Lines{long_line, "b"});
  CHECK(of(long_line + "y\n") == Lines{long_line + "y"});
  CHECK(LineFile(file.path).name == file.path);
  CHECK_THROWS_AS(LineFile("/no such folder/file"), FileError);
  CHECK_THROWS_AS(LineFile(std::filesystem::temp_directory_path().string()), FileError);
}

TEST_CASE("lines do not depend on the pieces in which a file is read") {
  constexpr std::uint64_t seed = 4;
  Random draw(seed);
  for (int i = 0; i < 20; ++i) {
    INFO("draw " << i << " of seed " << seed);
    const std::string text = random_text(draw, 150);
    const ScratchFile plain("many.txt"), packed("many.txt.gz");
    plain.write(text);
    packed.write(gzipped(text));
    CHECK(lines_of(plain.path) == split(text));
    CHECK(lines_of(packed.path) == split(text));
  }
}

TEST_CASE("each line that can be read is kept, and each other is told with its place and counted") {
  const ScratchFile file("each.txt");
  file.write("1\n \t\r\nx\n\n22\ny y\n333");
  const auto number = [](const std::string& line) {
    if (line == "x") throw InvalidInput("/ball/at", "is no\nnumber");
    if (line == "y y") throw InvalidInput("", "is no JSON", 1);
    return line.size();
  };
  long bad = 5;
  const Overheard overheard;
  CHECK(read_each(file.path, number, bad) == std::vector<std::size_t>{1, 2, 3});
  CHECK(bad == 7);
  CHECK(overheard.text() == file.path + ":3: /ball/at is no number\n" + file.path + ":6: is no JSON\n");
}

TEST_CASE("lines that were left out are told only if there are any") {
  const Overheard overheard;
  tell_left_out(0, 9);
  CHECK(overheard.text().empty());
  tell_left_out(2, 3);
  CHECK(overheard.text() == "bankshot: 2 of 5 lines were left out\n");
}

TEST_CASE("the name of a file is neither an option nor, unless allowed, standard output") {
  CHECK(file_name("out.svg").empty());
  CHECK(file_name("-odd name").empty());
  CHECK_THAT(file_name("--json"), Contains("\"--json\" is an option"));
  CHECK_THAT(file_name("-"), Contains("standard output"));
  CHECK(file_or_output("-").empty());
  CHECK(file_or_output("out.svg").empty());
  CHECK_THAT(file_or_output("--json"), Contains("\"--json\" is an option"));
}

TEST_CASE("as many threads work as are asked for, or as many as the machine has") {
  CHECK(threads_for(1) == 1);
  CHECK(threads_for(70) == 70);
  CHECK(threads_for(0) >= 1);
  CHECK(threads_for(-1) == threads_for(0));
}

TEST_CASE("processor time is that of one thread alone, and never runs back") {
  constexpr double busy = 0.02;  // s
  double other = 0;
  const double begin = cpu_seconds();
  std::thread([&] {
    const double first = cpu_seconds();
    double before = first;
    bool back = false;
    while (before - first < busy) {
      const double now = cpu_seconds();
      back = back || now < before;
      before = now;
    }
    other = back ? -1 : before - first;
  }).join();
  CHECK(other >= busy);
  CHECK(cpu_seconds() - begin < other);  // this thread only waited
}

TEST_CASE("the first signal is noted, and the second ends the program") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    INFO("signal " << signal);
    const int status = in_child([&] {
      std::signal(SIGHUP, SIG_DFL);
      const Interrupts interrupts;
      if (interrupted() != 0) return 1;
      raise(signal);
      if (interrupted() != signal) return 2;
      raise(signal);
      return 3;
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
  }
}

TEST_CASE("a hangup that was ignored stays ignored, and a closed pipe is an error of writing") {
  const int status = in_child([] {
    std::signal(SIGHUP, SIG_IGN);
    const Interrupts interrupts;
    raise(SIGHUP);
    int ends[2];
    if (interrupted() != 0 || pipe(ends) != 0) return 1;
    close(ends[0]);
    return write(ends[1], "x", 1) == -1 && errno == EPIPE ? 0 : 2;
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
