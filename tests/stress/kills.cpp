// SPDX-License-Identifier: MIT
//
// Ends `bankshot batch` at seeded moments, resumes it until it is done, and compares the output with that of an
// undisturbed run. A run is ended up to three times, when its output has grown to a drawn size. It is ended by SIGKILL,
// by SIGINT, by a limit on the size of files (a full disk), or by SIGKILL with the end of the output lost or zero, as
// after a power failure. With --parts the batch is cut into parts, each of which is ended in this way, and `merge` once
// as well. A part may also be started a second time while it runs, as by a scheduler that lost a node, with and without
// a lock that keeps the two apart.
//   kills --rounds 200 --seed 1 build/release/bankshot
//   kills --rounds 50 --parts 4 --seed 1 build/release/bankshot
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

#include "bankshot/scene/json.hpp"
#include "support/random_puzzle.hpp"

namespace {

namespace fs = std::filesystem;
using bankshot::test::Random;
using Words = std::vector<std::string>;

/// `lost`: killed, and the last writes are lost; `twice`: started again while it runs.
enum class End { kill, interrupt, full, lost, twice };

struct Tally {
  int kills = 0, interrupts = 0, full = 0, lost = 0, refused = 0, doubled = 0, in_time = 0, different = 0;
};

/// A command line, and the file that grows while it runs.
struct Command {
  Words words;
  fs::path grows;
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

long size_of(const fs::path& path) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  return none ? -1 : static_cast<long>(size);
}

/// Returns puzzles, and some lines that are not puzzles.
std::string puzzles(Random& r, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    bankshot::Puzzle p = random_puzzle(r, bankshot::test::families[i % 4],
                                       i % 8 < 6 ? bankshot::test::Model::rolling : bankshot::test::Model::spin)
                             .puzzle;
    p.id = std::to_string(i);
    out += i % 50 == 49 ? "no puzzle\n" : write_puzzle(p) + "\n";
  }
  return out;
}

pid_t start(const Words& words, const fs::path& complaints, long most_bytes = 0) {
  const pid_t child = fork();
  if (child != 0) return child;
  const int errors = open(complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(errors, STDERR_FILENO);
  if (most_bytes > 0) {
    const rlimit limit{static_cast<rlim_t>(most_bytes), static_cast<rlim_t>(most_bytes)};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<char*> arguments;
  for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// Loses the last writes, as when a machine dies: cuts them off, or sets them to zero as in a file system that had only
/// allocated space.
void lose_writes(const fs::path& path, Random& r) {
  constexpr double at_most = 1 << 16;
  const long size = size_of(path);
  if (size <= 0 || !fs::exists(path.string() + ".progress")) return;  // all was on disk before the journal was removed
  const long from = size - static_cast<long>(r.uniform(0, std::min(at_most, static_cast<double>(size))));
  if (r.integer(0, 1) == 0) return fs::resize_file(path, static_cast<std::uintmax_t>(from));
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(from);
  file << std::string(static_cast<std::size_t>(r.uniform(0, static_cast<double>(size - from))), '\0');
}

int exit_of(pid_t child, const fs::path& complaints) {
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 2)) return WEXITSTATUS(status);
  throw std::runtime_error(fmt::format("a program ended with status {:#x}: {}", status, text_of(complaints)));
}

class Disturbance {
 public:
  Disturbance(const fs::path& folder, std::uint64_t seed) : random(seed), complaints_(folder / "stderr") {}

  /// Runs the command to its end, undisturbed.
  void finish(const Command& c) { run(c, {}, 0); }

  /// Ends it up to three times, then lets it finish. One time in four the size drawn is that of the whole output, to
  /// test the last steps.
  void disturb(const Command& c, long size, const std::vector<End>& ends) {
    bool done = false;
    for (int times = random.integer(1, 3), i = 0; i < times && !done; ++i) {
      const auto bytes =
          random.integer(0, 3) == 0 ? size : static_cast<long>(random.uniform(0, static_cast<double>(size)));
      const End end = ends[static_cast<std::size_t>(random.integer(0, static_cast<int>(ends.size()) - 1))];
      done = end == End::twice ? twice(c, bytes) : run(c, end, bytes);
    }
    if (done)
      ++tally.in_time;
    else
      finish(c);
  }

  Random random;
  Tally tally;

 private:
  /// Returns false when the process ended before it had written so much.
  bool wait_for(pid_t child, const fs::path& grows, long bytes) const {
    siginfo_t info{};
    while (size_of(grows) < bytes) {
      info.si_pid = 0;
      if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0)
        return false;
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    return true;
  }

  /// Runs until it ends by itself or the output has so many bytes; returns true when it is done.
  bool run(const Command& c, std::optional<End> end, long bytes) {
    const pid_t child = start(c.words, complaints_, end == End::full ? bytes : 0);
    const bool by_signal = end && end != End::full;
    if (by_signal && wait_for(child, c.grows, bytes)) kill(child, end == End::interrupt ? SIGINT : SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
    if (end == End::lost && WIFSIGNALED(status)) return lose_writes(c.grows, random), ++tally.lost, false;
    if (by_signal && WIFSIGNALED(status)) return ++tally.kills, false;  // or it had not begun to listen
    if (end == End::interrupt && WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT)
      return ++tally.interrupts, false;
    if (end == End::full && WIFEXITED(status) && WEXITSTATUS(status) == 2) return ++tally.full, false;
    throw std::runtime_error(fmt::format("the program ended with status {:#x}: {}", status, text_of(complaints_)));
  }

  /// Starts the same part a second time while it runs. With a shared lock the second run is refused. A journal that is
  /// replaced by another file of the same name simulates a file system without locks between machines.
  bool twice(const Command& c, long bytes) {
    const pid_t first = start(c.words, complaints_);
    const bool runs = wait_for(first, c.grows, bytes), locked = random.integer(0, 1) == 0;
    const fs::path journal = c.grows.string() + ".progress", copy = c.grows.string() + ".copy";
    std::error_code gone;
    if (runs && !locked && fs::copy_file(journal, copy, gone)) fs::rename(copy, journal);
    const fs::path complaints = complaints_.string() + "-2";
    const int second = exit_of(start(c.words, complaints), complaints);
    const std::string refusal = text_of(complaints);
    const int exit = exit_of(first, complaints_);
    if (!locked) ++tally.doubled;
    if (locked && second == 2) {
      ++tally.refused;
      if (refusal.find("another bankshot is writing this file") == std::string::npos || exit != 0)
        throw std::runtime_error("a part was started twice: " + refusal + text_of(complaints_));
    }
    return exit == 0 && second == 0;
  }

  fs::path complaints_;
};

/// Returns the command of a batch in one run.
Command batch(const std::string& program, const fs::path& input, const fs::path& output, int threads) {
  return {{program, "batch", input, "-o", output, "-j", std::to_string(threads), "--no-timing", "--quiet", "--resume"},
          output};
}

/// Returns the command of one of n parts, and the file that grows until the part is whole.
Command part(const std::string& program, const fs::path& input, const fs::path& output, int k, int n, int threads) {
  Command c = batch(program, input, output, threads);
  for (const std::string& word : {std::string("--part"), fmt::format("{}/{}", k, n)}) c.words.push_back(word);
  const bool packed = output.extension() == ".gz";
  c.grows = (packed ? fs::path(output).replace_extension() : output).string() + (packed ? ".partial.gz" : ".partial");
  return c;
}

Command merge(const std::string& program, const Words& parts, const fs::path& output) {
  Command c{{program, "merge", "--quiet", "-o", output}, output.string() + ".partial"};
  if (output.extension() == ".gz") c.grows += ".gz";
  c.words.insert(c.words.end(), parts.begin(), parts.end());
  return c;
}

/// Returns true when the output is as expected and no unfinished file is left beside it.
bool same(const fs::path& output, const std::string& expected) {
  for (const auto& entry : fs::directory_iterator(output.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (name.find(".partial") != std::string::npos || name.find(".progress") != std::string::npos) return false;
  }
  return text_of(output) == expected;
}

/// Plays rounds on a plain or a compressed output.
void play(Disturbance& d, const std::string& program, const fs::path& input, const std::string& suffix, int parts,
          int rounds) {
  const fs::path folder = input.parent_path() / "round", whole = input.parent_path() / ("whole" + suffix);
  d.finish(batch(program, input, whole, 1));
  const std::string expected = text_of(whole);
  std::vector<long> sizes;  // of the parts
  for (int k = 0; k < parts; ++k) {
    const fs::path output = input.parent_path() / ("part" + suffix);
    d.finish(part(program, input, output, k, parts, 1));
    sizes.push_back(size_of(output));
  }
  for (int i = 0; i < rounds; ++i) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    const fs::path output = folder / ("out" + suffix);
    Words names;
    for (int k = 0; k < parts; ++k) {
      names.push_back(folder / (std::to_string(k) + suffix));
      d.disturb(part(program, input, names.back(), k, parts, d.random.integer(1, 3)),
                sizes[static_cast<std::size_t>(k)],
                {End::kill, End::kill, End::interrupt, End::full, End::lost, End::twice});
    }
    const Command last =
        parts > 0 ? merge(program, names, output) : batch(program, input, output, d.random.integer(1, 3));
    d.disturb(last, size_of(whole),
              parts > 0 ? std::vector{End::kill} : std::vector{End::kill, End::interrupt, End::full, End::lost});
    if (same(output, expected)) continue;
    std::cout << fmt::format("FAILED round {} {}: the output differs\n", i, suffix);
    ++d.tally.different;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Ends bankshot batch at seeded moments and resumes it");
  int rounds = 200, count = 1500, parts = 0;
  std::uint64_t seed = 1;
  std::string program;
  app.add_option("--rounds", rounds)->capture_default_str();
  app.add_option("--count", count, "Puzzles a round")->capture_default_str();
  app.add_option("--parts", parts, "Parts a round, merged; 0: in one go")->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("program", program)->required();
  CLI11_PARSE(app, argc, argv);
  const fs::path folder = fs::temp_directory_path() / fmt::format("bankshot-kills-{}", getpid());
  fs::create_directory(folder);
  Disturbance d(folder, seed);
  const fs::path input = folder / "in.jsonl";
  std::ofstream(input, std::ios::binary) << puzzles(d.random, count);
  for (const char* suffix : {".jsonl", ".jsonl.gz"}) play(d, program, input, suffix, parts, rounds / 2);
  fs::remove_all(folder);
  const Tally& t = d.tally;
  std::cout << fmt::format(
      "kills seed {}: {} rounds of {} parts, {} kills, {} more with writes lost, {} interrupts, {} files at their "
      "limit, {} parts refused while they ran and {} run twice at once, {} runs done before they were ended, "
      "{} different\n",
      seed, rounds, parts, t.kills, t.lost, t.interrupts, t.full, t.refused, t.doubled, t.in_time, t.different);
  return t.different == 0 && t.kills > 0 ? 0 : 1;
}
