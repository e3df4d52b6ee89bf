// SPDX-License-Identifier: MIT
//
// bankshot generate: seeded puzzles that have a shot, one JSON a line.
#include "bankshot/plan/generate.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "app/batch/output.hpp"
#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"
#include "app/option_checks.hpp"
#include "app/scene_flags.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"
#include "json/reader.hpp"

namespace bankshot::app::generate {
namespace {

/// In the order of Wish::Kind.
constexpr const char* kinds[] = {"pocket", "stop", "pass", "kick", "pot", "carom"};

struct Arguments {
  std::uint64_t seed = 0;
  long count = 0;
  std::string table = "pool-9ft", physics = "spin", cushions = "1-3", then = "0", difficulty, target, out = "-";
  int balls = 0;
  bool unique = false;
};

int whole(const std::string& text) {
  constexpr std::size_t most_digits = 5;
  const bool digits =
      !text.empty() && text.size() <= most_digits && text.find_first_not_of("0123456789") == std::string::npos;
  const int n = digits ? std::stoi(text) : -1;
  return n <= max_cushions ? n : -1;
}

/// "2", "1-3" or "top,left".
CushionRule read_rule(const std::string& text, const Table& table, std::string_view flag) {
  if (const int n = whole(text); n >= 0) return CushionRule::exactly(n);
  const auto dash = text.find('-');
  const int low = whole(text.substr(0, dash)), high = dash == std::string::npos ? -1 : whole(text.substr(dash + 1));
  if (low >= 0 && high >= low) return {low, high, {}};
  const std::vector<std::string>& all = table.cushions;
  const std::vector<std::string_view> names(all.begin(), all.end());
  std::vector<Contact> contacts;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const auto it = std::find(all.begin(), all.end(), word);
    if (it == all.end())
      throw FileError(fmt::format("{}: {} is neither a number, LOW-HIGH nor a cushion{}", flag, quote(word),
                                  known_words(word, names)));
    contacts.push_back(Contact::rail(static_cast<int>(it - all.begin())));
  }
  return CushionRule::in_order(std::move(contacts));
}

Wish read_wish(const Arguments& a) {
  Wish w;
  const Scene scene = read_scene_flags(a.table, a.physics, "--");
  w.table = scene.table, w.physics = scene.physics, w.ball = scene.ball;
  w.cushions = read_rule(a.cushions, w.table, "--cushions");
  w.then = read_rule(a.then, w.table, "--then");
  w.others = a.balls;
  for (const Difficulty d : {Difficulty::easy, Difficulty::medium, Difficulty::hard})
    if (a.difficulty == name(d)) w.difficulty = d;
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    if (a.target == kinds[i]) w.kind = static_cast<Wish::Kind>(i);
  if ((w.kind == Wish::Kind::pocket || w.kind == Wish::Kind::pot) && w.table.pockets.empty())
    throw FileError("--target " + a.target + ": this table has no pockets");
  if (a.then != "0" && w.kind != Wish::Kind::pot)
    throw FileError("--then: is of the ball that is sent into a pocket, with --target pot");
  if (w.kind == Wish::Kind::stop && deceleration(w.physics) == 0)
    throw FileError("--target stop: without friction no ball comes to rest");
  w.unique = a.unique;
  return w;
}

/// One puzzle as text, or why there is none.
struct Made {
  std::string line;
  Tries tries;
};

Made make(const Arguments& a, const Wish& w, long number) {
  Made made;
  Random random(a.seed, static_cast<std::uint64_t>(number));
  auto g = bankshot::generate(w, random, &made.tries);
  if (!g) return made;
  g->puzzle.id = fmt::format("\"{}-{}\"", a.seed, number);
  g->puzzle.about = fmt::format(R"({{"difficulty":"{}"}})", name(difficulty(g->answer.shots.front())));
  made.line = write_puzzle(g->puzzle, as_json(a.table), as_json(a.physics)) + "\n";
  return made;
}

int run(const Arguments& a) {
  const Wish wish = read_wish(a);
  batch::Output out(a.out);  // a name that cannot be written is told before the work
  if (out.regular()) out.cut(0);
  // The first alone: an impossible wish is told after one puzzle's tries.
  constexpr long block = 64;
  for (long done_so_far = 0; done_so_far < a.count;) {
    std::vector<Made> made(static_cast<std::size_t>(std::min(done_so_far ? block : 1, a.count - done_so_far)));
    tbb::parallel_for(std::size_t{0}, made.size(),
                      [&](std::size_t i) { made[i] = make(a, wish, done_so_far + static_cast<long>(i) + 1); });
    std::string lines;
    const auto missing = std::find_if(made.begin(), made.end(), [](const Made& m) { return m.line.empty(); });
    for (auto m = made.begin(); m != missing; ++m, ++done_so_far) lines += m->line;
    if (!lines.empty()) out.write(out.gzip() ? gzipped(lines) : lines);
    if (missing == made.end()) continue;
    std::cerr << fmt::format("bankshot: puzzle {} of {} was not found: {}\n", done_so_far + 1, a.count,
                             missing->tries.text());
    return nothing_solved;
  }
  if (out.gzip() && out.written() == 0) out.write(gzipped(""));  // an empty file is no gzip file
  out.finish();
  return done;
}

std::string help() {
  return fmt::format(
      "Every puzzle was solved before it is printed, by `solve`, at its target's centre. The same seed and wishes\n"
      "give the same puzzles; a larger --count goes on where a smaller one ends. Difficulty, of the best shot and\n"
      "a player with the default noise (0.125 degrees, 0.075 m/s):\n"
      "  easy    made in at least {:.0f} % of tries, and {:.2g} degrees of aim to both sides still make it\n"
      "  hard    made in less than {:.0f} % of tries, or less than {:.3g} degrees to one side\n"
      "  medium  between\n"
      "--unique: `solve --all` finds exactly one shot. With spin its completeness is measured, not proved.\n"
      "A puzzle is given up after {} tries; standard error says what became of them. Its difficulty stands in the\n"
      "key \"about\".",
      100 * easy_success, degrees(easy_margin), 100 * hard_success, degrees(hard_margin), Wish{}.tries);
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("generate", "Make puzzles that have a shot");
  command->add_option("--count", a->count, "How many")->required()->check(whole_number);
  command->add_option("--seed", a->seed, "Other seeds, other puzzles")->required()->check(whole_number);
  command->add_option("--table", a->table, "A table's name, or its JSON")->capture_default_str();
  command->add_option("--physics", a->physics, "A physics' name, or its JSON")->capture_default_str();
  command
      ->add_option("--cushions", a->cushions, "A number; LOW-HIGH, a number drawn for each puzzle; or names: top,left")
      ->capture_default_str();
  command
      ->add_option(
          "--target", a->target,
          "pocket, stop (rest at a point) or pass (through a point), else one of these is drawn; kick (touch a\n"
          "ball), pot (send one into a pocket), carom (touch one and then another)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(kinds), std::end(kinds))));
  command->add_option("--balls", a->balls, "Other balls on the table; 0 is three with kick, pot and carom")
      ->check(CLI::Range(0, 21));
  command->add_option("--then", a->then, "As --cushions, of the ball that is sent into a pocket")
      ->capture_default_str();
  command->add_option("--difficulty", a->difficulty, "easy, medium or hard, see below; else any")
      ->check(CLI::IsMember({"easy", "medium", "hard"}));
  command->add_flag("--unique", a->unique, "Puzzles with exactly one shot");
  command->add_option("-o,--output", a->out, "Write to this file, packed where it ends in .gz; - is standard output")
      ->capture_default_str();
  explain(*command, help(),
          {{"bankshot generate --count 20 --seed 1 -o puzzles.jsonl", "20 puzzles on a 9-foot table"},
           {"bankshot generate --count 3 --seed 7 --table carom-10ft --cushions 3 --difficulty easy",
            "three easy ones by three cushions"},
           {"bankshot generate --count 5 --seed 3 --target pot --cushions 0 --then 1", "five banks"},
           {"bankshot generate --count 5 --seed 3 --table carom-10ft --target carom --cushions 3-6 --balls 2",
            "five of three-cushion billiards"}},
          "0 done; 1 a puzzle was not found; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::generate
