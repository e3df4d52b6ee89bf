// SPDX-License-Identifier: MIT
//
// Ends `bankshot batch` at seeded moments, resumes it until it is done, and compares the output with
// that of a run nobody disturbed. A round ends the program up to three times: by SIGKILL or SIGINT
// when the output has grown to a drawn size, or by a limit on the size of files (a full disk).
//   kills --rounds 200 --seed 1 build/release/bankshot
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

enum class End { kill, interrupt, full };

struct Tally {
  int kills = 0, interrupts = 0, full = 0, in_time = 0, different = 0;
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Puzzles, among them lines that are none.
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

pid_t start(const std::vector<std::string>& words, const fs::path& complaints, long most_bytes) {
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

/// Runs until it ends by itself or the output has so many bytes; true when it was done.
bool run(const std::vector<std::string>& words, const fs::path& output, std::optional<End> end, long bytes,
         Tally& tally) {
  const fs::path complaints = output.parent_path() / "stderr";
  const pid_t child = start(words, complaints, end == End::full ? bytes : 0);
  int status = 0;
  const auto running = [&] { return waitpid(child, &status, WNOHANG) == 0; };
  std::error_code none;
  bool alive = true;
  if (end == End::kill || end == End::interrupt)
    while ((alive = running()) && static_cast<long>(fs::file_size(output, none)) < bytes)
      std::this_thread::sleep_for(std::chrono::microseconds(50));
  if (alive) {
    if (end == End::kill) kill(child, SIGKILL);
    if (end == End::interrupt) kill(child, SIGINT);
    waitpid(child, &status, 0);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  if (end == End::kill && WIFSIGNALED(status)) return ++tally.kills, false;
  if (end == End::interrupt && WIFSIGNALED(status)) return ++tally.kills, false;  // it had not begun to listen
  if (end == End::interrupt && WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT)
    return ++tally.interrupts, false;
  if (end == End::full && WIFEXITED(status) && WEXITSTATUS(status) == 2) return ++tally.full, false;
  throw std::runtime_error(fmt::format("the program ended with status {:#x}: {}", status, text_of(complaints)));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Ends bankshot batch at seeded moments and resumes it");
  int rounds = 200, count = 1500;
  std::uint64_t seed = 1;
  std::string program;
  app.add_option("--rounds", rounds)->capture_default_str();
  app.add_option("--count", count, "Puzzles a round")->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("program", program)->required();
  CLI11_PARSE(app, argc, argv);
  const fs::path folder = fs::temp_directory_path() / fmt::format("bankshot-kills-{}", getpid());
  fs::create_directory(folder);
  Random random(seed);
  Tally tally;
  const fs::path input = folder / "in.jsonl";
  std::ofstream(input, std::ios::binary) << puzzles(random, count);
  for (const char* suffix : {".jsonl", ".jsonl.gz"}) {
    const fs::path whole = folder / (std::string("whole") + suffix), output = folder / (std::string("out") + suffix);
    const auto command = [&](const fs::path& to, int threads) {
      return std::vector<std::string>{program,       "batch",   input,     "-o", to, "-j", std::to_string(threads),
                                      "--no-timing", "--quiet", "--resume"};
    };
    run(command(whole, 1), whole, {}, 0, tally);
    const std::string expected = text_of(whole);
    for (int i = 0; i < rounds / 2; ++i) {
      fs::remove(output);
      bool done = false;
      for (int ends = random.integer(1, 3), k = 0; k < ends && !done; ++k) {
        const auto bytes = static_cast<long>(random.uniform(0, static_cast<double>(expected.size())));
        done = run(command(output, random.integer(1, 3)), output, static_cast<End>(random.integer(0, 2)), bytes, tally);
      }
      if (!done)
        run(command(output, 2), output, {}, 0, tally);
      else
        ++tally.in_time;
      const bool same = text_of(output) == expected && !fs::exists(output.string() + ".progress");
      if (!same) std::cout << fmt::format("FAILED round {} {}: the output differs\n", i, suffix);
      tally.different += !same;
    }
  }
  fs::remove_all(folder);
  std::cout << fmt::format(
      "kills seed {}: {} rounds, {} kills, {} interrupts, {} files at their limit, {} rounds done before they were "
      "ended, {} different\n",
      seed, rounds, tally.kills, tally.interrupts, tally.full, tally.in_time, tally.different);
  return tally.different == 0 ? 0 : 1;
}
