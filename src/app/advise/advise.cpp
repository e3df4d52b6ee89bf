// SPDX-License-Identifier: MIT
//
// bankshot advise: estimates a player's errors from attempts.
#include "bankshot/learn/advise.hpp"

#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/read_each.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::app::advise {
namespace {

struct Arguments {
  std::string file = "-", out, shots;
  int jobs = 0;
  bool quiet = false;
};

int run(const Arguments& a) {
  long bad = 0, bad_shots = 0;
  const auto attempts = read_each(
      a.file, [](const std::string& line) { return read_attempt(line); }, bad);
  if (attempts.empty()) throw FileError(a.file + ": no attempt in it" + (bad > 0 ? " that can be read" : ""));
  std::vector<Puzzle> shots;
  if (!a.shots.empty())
    shots = read_each(
        a.shots, [](const std::string& line) { return read_puzzle(line); }, bad_shots);
  const Advice advice = bankshot::advise(attempts, {.shots = shots, .threads = threads_for(a.jobs)});
  print_after(
      [&] {
        if (!a.out.empty()) write_file(a.out, noise_of(advice) + "\n");
      },
      to_json(advice) + "\n");
  if (!a.quiet) std::cerr << message_of(advice) << '\n';
  tell_left_out(bad, attempts.size());
  tell_left_out(bad_shots, shots.size());
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("advise", "Learn a player's noise from attempts, and choose shots by it");
  command->add_option("attempts", a->file, "Attempts, one per line; - reads standard input")->capture_default_str();
  command->add_option("--shots", a->shots, "Puzzles, one per line, from which this player may choose")
      ->check(CLI::ExistingFile);
  command->add_option("-o,--output", a->out, "Write the noise alone to this file, for a puzzle's \"noise\"")
      ->check(file_or_output);
  command->add_option("-j,--jobs", a->jobs, "Threads; 0: one per core")->capture_default_str();
  command->add_flag("--quiet", a->quiet, "Write no summary to standard error");
  explain(
      *command,
      "An attempt is a recording (docs/recordings.md) with the \"shot\" or the \"puzzle\" that was meant, and what\n"
      "happened: a \"track\", a \"rest\", or only whether it was \"made\". Its physics counts as known, so fit it "
      "first.\n"
      "Standard output gets one line of JSON: the errors of this player in aim, speed and spin, with intervals of\n"
      "95 %; the errors on average (too hard, too far to the left); the errors of each attempt; and for --shots the\n"
      "best shot of each puzzle for this player, likeliest first.",
      {{"bankshot advise attempts.jsonl -o noise.json", "the player's noise"},
       {"bankshot advise attempts.jsonl --shots puzzles.jsonl", "the noise, and which shots to choose"}},
      "0 done; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::advise
