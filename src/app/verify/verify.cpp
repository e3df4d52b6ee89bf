// SPDX-License-Identifier: MIT
//
// bankshot verify: checks answers against their puzzles, each claim against a replay in 50 digits.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <array>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/line_file.hpp"
#include "bankshot/scene/json.hpp"
#include "service/solve_flags.hpp"
#include "truth/claims.hpp"

namespace bankshot::app::verify {
namespace {

using truth::Check;
using truth::Claim;

/// One puzzle, its answer, and the result of the check.
struct Pair {
  std::string puzzle, answer;
  long line;
  std::string id;  ///< JSON text; empty if there is no id
  Status status = Status::invalid;
  std::size_t shots = 0;
  bool beside = false;
  std::vector<Check> checks;
  std::set<std::string> unread;
  std::string bad;  ///< why the answer cannot be read
};

/// Checks one pair. `player`: the player whose errors the answers were computed for; empty: the puzzle's own.
void check(Pair& pair, const std::string& player) {
  std::optional<Puzzle> puzzle;
  try {
    puzzle = read_puzzle(pair.puzzle);
    service::set_player(*puzzle, player);
  } catch (const InvalidInput&) {
    // The answer must say so.
  }
  pair.id = read_id(pair.puzzle);
  try {
    const Answer a = read_answer(pair.answer, puzzle ? &*puzzle : nullptr, &pair.unread);
    pair.status = a.status;
    pair.shots = a.shots.size();
    pair.beside =
        puzzle && !a.shots.empty() && a.shots.front().verification.off_centre && !a.shots.front().provenance.moved;
    pair.checks = truth::check(puzzle ? &*puzzle : nullptr, pair.id, a);
  } catch (const InvalidInput& e) {
    pair.bad = fmt::format("{}{}{}", e.path, e.path.empty() ? "" : ": ", e.what());
  }
}

/// Totals over all pairs.
class Tally {
 public:
  void add(const Pair& p) {
    ++answers_;
    ++of_status_[static_cast<std::size_t>(p.status)];
    shots_ += p.shots;
    beside_ += p.beside;
    unread_.insert(p.unread.begin(), p.unread.end());
    bool failed = false;
    for (const Check& c : p.checks) {
      One& one = of_claim_[static_cast<std::size_t>(c.claim)];
      ++one.checked;
      one.failed += !c.holds();
      failed = failed || !c.holds();
      if (one.checked == 1 || ratio(c) > ratio(one.worst)) one.worst = c, one.worst_line = p.line;
    }
    failed_ += failed;
  }

  bool clean() const { return failed_ == 0; }

  std::string text() const {
    std::string out =
        fmt::format("{} answers: {} solved, {} no-shot, {} budget, {} invalid; {} shots", answers_, of(Status::solved),
                    of(Status::no_shot), of(Status::budget), of(Status::invalid), shots_);
    if (beside_) out += fmt::format("; {} say that they are beside the target's centre", beside_);
    out += fmt::format("\n\n{:<14} {:>9} {:>8}   worst, and how far off is allowed\n", "claim", "checked", "failed");
    for (int i = 0; i < truth::claims; ++i) {
      const One& one = of_claim_[static_cast<std::size_t>(i)];
      if (one.checked == 0) continue;
      out += fmt::format("{:<14} {:>9} {:>8}", truth::name(static_cast<Claim>(i)), one.checked, one.failed);
      if (one.worst.allowed > 0)
        out += fmt::format("   {:.2g} of {:.2g} {} on line {}", one.worst.off, one.worst.allowed,
                           truth::unit(one.worst.claim), one.worst_line);
      out += "\n";
    }
    out +=
        "not checked: whether a no-shot has a shot, the nearest miss, tip, scratch, cue_rests, ranks, counts, "
        "time_us\n";
    if (!unread_.empty()) out += fmt::format("not known here, so not checked: {}\n", fmt::join(unread_, ", "));
    return out + (clean() ? "\nevery claim holds\n" : fmt::format("\n{} of {} answers fail\n", failed_, answers_));
  }

 private:
  struct One {
    long checked = 0, failed = 0;
    Check worst{Claim::form};
    long worst_line = 0;
  };
  static double ratio(const Check& c) { return c.off > 0 ? c.off / std::max(c.allowed, 1e-300) : 0; }
  long of(Status s) const { return of_status_[static_cast<std::size_t>(s)]; }

  long answers_ = 0, failed_ = 0, beside_ = 0;
  std::size_t shots_ = 0;
  std::array<long, 4> of_status_{};
  std::array<One, truth::claims> of_claim_{};
  std::set<std::string> unread_;
};

std::string failure_text(const Pair& p, const std::string& file) {
  std::string out;
  for (const Check& c : p.checks) {
    if (c.holds()) continue;
    const std::string shot = p.shots > 1 ? fmt::format("shot {}, ", c.shot + 1) : "";
    out += fmt::format("{}{}{}: {}", out.empty() ? "" : "; ", shot, truth::name(c.claim), c.what);
  }
  return one_line(
             fmt::format("{}:{}: {} fails: {}", file, p.line, p.id.empty() ? "an answer without an id" : p.id, out)) +
         "\n";
}

/// Returns the next pairs of lines; fewer than `most` at the end. If one file is longer, the last pair says so in
/// `bad`.
std::vector<Pair> next_pairs(LineFile& puzzles, LineFile& answers, std::size_t most) {
  std::vector<Pair> out;
  while (out.size() < most) {
    Pair p;
    const bool puzzle = puzzles.next(p.puzzle), answer = answers.next(p.answer);
    if (!puzzle && !answer) break;
    p.line = answers.number;
    if (!answer) p.bad = fmt::format("ends here, and {} goes on", puzzles.name), ++p.line;
    if (!puzzle) p.bad = fmt::format("has an answer more than {} has puzzles", puzzles.name);
    out.push_back(std::move(p));
    if (!puzzle || !answer) break;
  }
  return out;
}

int run(const std::string& puzzle_file, const std::string& answer_file, const std::string& player) {
  service::check_player(player);
  if (puzzle_file == "-" && answer_file == "-") throw FileError("puzzles and answers cannot both be standard input");
  LineFile puzzles(puzzle_file), answers(answer_file);
  constexpr std::size_t block = 2000;  // keeps all cores busy and memory bounded
  Tally tally;
  for (;;) {
    std::vector<Pair> pairs = next_pairs(puzzles, answers, block);
    if (pairs.empty()) break;
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
      if (pairs[i].bad.empty()) check(pairs[i], player);
    });
    for (const Pair& p : pairs) {
      if (!p.bad.empty()) throw FileError(fmt::format("{}:{}: {}", answers.name, p.line, p.bad));
      tally.add(p);
      const bool holds = std::all_of(p.checks.begin(), p.checks.end(), [](const Check& c) { return c.holds(); });
      if (!holds) print(failure_text(p, answers.name));
    }
  }
  print(tally.text());
  return tally.clean() ? done : some_fail;
}

}  // namespace

Run add(CLI::App& app) {
  struct Arguments {
    std::string puzzles, answers, player;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("verify", "Replay every shot of many answers in 50 digits and check what they claim");
  command->add_option("puzzles", a->puzzles, "Puzzles, one per line; - reads standard input")->required();
  command->add_option("shots", a->answers, "Their answers, line by line in the same order; - reads standard input")
      ->required();
  command->add_option("--noise", a->player, "The player that `batch --noise` named");
  explain(
      *command,
      "These are checked for each shot: launch speed and aim inside their bounds, the spin, the cushions (as asked "
      "and\n"
      "as met), the target made with nothing in the way, its miss, place, time and speed of arrival, condition, both\n"
      "ends of each margin and 50 launches inside, success against 1,000 seeded draws, and value. A place may be off "
      "by\n"
      "1e-9 of the table's diagonal, or by what rounding does under the shot's condition if that is more. An answer\n"
      "that fails is printed as FILE:LINE: ID. A file whose name ends in .gz is unpacked.",
      {{"bankshot verify puzzles.jsonl shots.jsonl", "the claims, and how far off the worst is"}},
      "0 every claim holds; 1 some answer fails; 2 a file is bad, or bad usage.");
  return [a] { return run(a->puzzles, a->answers, a->player); };
}

}  // namespace bankshot::app::verify
