// SPDX-License-Identifier: MIT
//
// bankshot generate: seeded puzzles that have a shot, one JSON per line.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iostream>

#include "app/batch/output.hpp"
#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"
#include "app/option_checks.hpp"
#include "service/options.hpp"
#include "service/wishes.hpp"

namespace bankshot::app::generate {
namespace {

struct Arguments : service::Wishes {
  long count = 0;
  std::string out = "-";
};

int run(const Arguments& a) {
  const Wish wish = service::read_wish(a);
  batch::Output out(a.out);  // reports a name that cannot be written before the work begins
  if (out.regular()) out.cut(0);
  // The first block is a single puzzle, so that an impossible wish is reported after the tries of one puzzle.
  constexpr long block = 64;
  for (long done_so_far = 0; done_so_far < a.count;) {
    std::vector<service::Made> made(static_cast<std::size_t>(std::min(done_so_far ? block : 1, a.count - done_so_far)));
    tbb::parallel_for(std::size_t{0}, made.size(),
                      [&](std::size_t i) { made[i] = service::make(a, wish, done_so_far + static_cast<long>(i) + 1); });
    std::string lines;
    const auto missing = std::find_if(made.begin(), made.end(), [](const service::Made& m) { return m.line.empty(); });
    for (auto m = made.begin(); m != missing; ++m, ++done_so_far) lines += m->line;
    if (!lines.empty()) out.write(out.gzip() ? gzipped(lines) : lines);
    if (missing == made.end()) continue;
    std::cerr << fmt::format("bankshot: puzzle {} of {} was not found: {}\n", done_so_far + 1, a.count,
                             missing->tries.text());
    return nothing_solved;
  }
  if (out.gzip() && out.written() == 0) out.write(gzipped(""));  // an empty file is not a gzip file
  out.finish();
  return done;
}

std::string help() {
  return fmt::format(
      "`solve` has solved every puzzle, at the centre of its target, before it is printed. The same seed and wishes\n"
      "give the same puzzles; a larger --count continues the list of a smaller one. Difficulty is that of the best\n"
      "shot for a player with the default noise (0.125 degrees, 0.075 m/s):\n"
      "  easy    made in at least {:.0f} % of tries, and still made with {:.2g} degrees of aim to both sides\n"
      "  hard    made in less than {:.0f} % of tries, or with less than {:.3g} degrees to one side\n"
      "  medium  between\n"
      "--unique: `solve --all` finds exactly one shot. With spin that search may miss shots; how many was measured.\n"
      "A puzzle is given up after {} tries; standard error says what became of them. The key \"about\" holds the\n"
      "difficulty.",
      100 * easy_success, degrees(easy_margin), 100 * hard_success, degrees(hard_margin), Wish{}.tries);
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("generate", "Make puzzles that have a shot");
  command->add_option("--count", a->count, "How many puzzles")->required()->check(service::whole_number);
  command->add_option("--seed", a->seed, "Seed of the random puzzles")->required()->check(service::whole_number);
  command->add_option("--table", a->table, "A table by its name or as JSON")->capture_default_str();
  command->add_option("--physics", a->physics, "The physics by its name or as JSON")->capture_default_str();
  command
      ->add_option("--cushions", a->cushions, "A number; LOW-HIGH, a number drawn for each puzzle; or names: top,left")
      ->capture_default_str();
  command
      ->add_option(
          "--target", a->target,
          "pocket, stop (rest at a point), pass (through a point), kick (touch a ball), pot (a ball into a pocket)\n"
          "or carom (touch one ball and then another); without it one of the first three is drawn")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(service::kinds), std::end(service::kinds))));
  command
      ->add_option("--balls", a->balls,
                   "Other balls on the table; 0 means three for kick, pot and carom, and none otherwise")
      ->check(CLI::Range(0, service::most_balls));
  command->add_option("--then", a->then, "Cushions of the object ball of a pot, as for --cushions")
      ->capture_default_str();
  command->add_option("--difficulty", a->difficulty, "easy, medium or hard, see below; without it any")
      ->check(CLI::IsMember({"easy", "medium", "hard"}));
  command->add_flag("--unique", a->unique, "Only puzzles with exactly one shot");
  command->add_option("--speed", a->speed, "Launch speeds that a puzzle allows: LOW,HIGH or one speed [m/s]")
      ->delimiter(',')
      ->expected(1, 2);
  command->add_flag("--no-spin", a->no_spin, "The cue ball is struck in the centre");
  command->add_option("-o,--output", a->out, "Write to this file, packed if its name ends in .gz; - is standard output")
      ->capture_default_str();
  explain(*command, help(),
          {{"bankshot generate --count 20 --seed 1 -o puzzles.jsonl", "20 puzzles on a 9-foot table"},
           {"bankshot generate --count 3 --seed 7 --table carom-10ft --cushions 3 --difficulty easy",
            "three easy puzzles with three cushions"},
           {"bankshot generate --count 5 --seed 3 --target pot --cushions 0 --then 1 --no-spin --speed 1,4",
            "five banks at a player's speeds, without spin"},
           {"bankshot generate --count 5 --seed 3 --table carom-10ft --target carom --cushions 3-6 --balls 2",
            "five puzzles of three-cushion billiards"}},
          "0 done; 1 a puzzle was not found; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::generate
