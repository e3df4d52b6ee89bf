// SPDX-License-Identifier: MIT
#include "app/batch/tally.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::app::batch {
namespace {

std::string clock(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

void say(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

void Tally::add(const Puzzle& puzzle, const Answer& answer) {
  simulations += answer.simulations;
  if (answer.status == Status::no_shot) ++no_shot;
  if (answer.status == Status::budget) ++budget;
  if (answer.status != Status::solved) return;
  ++solved;
  const double miss = answer.shots.front().verification.miss;
  if (miss > tolerance::exact_miss * puzzle.table.diagonal())
    ++beside;
  else
    worst_miss = std::max(worst_miss, miss);
}

void Tally::add_invalid(long line) {
  ++invalid;
  if (first_invalid == 0) first_invalid = line;
}

void Tally::add(const Tally& later) {
  solved += later.solved;
  no_shot += later.no_shot;
  budget += later.budget;
  invalid += later.invalid;
  if (first_invalid == 0) first_invalid = later.first_invalid;
  beside += later.beside;
  worst_miss = std::max(worst_miss, later.worst_miss);
  simulations += later.simulations;
}

void Cost::add(const Cost& more) {
  read += more.read;
  parse += more.parse;
  search += more.search;
  certify += more.certify;
  robustness += more.robustness;
  format += more.format;
  write += more.write;
}

Progress::Progress(long kept, double share, bool shown)
    : kept_(kept), share_before_(std::max(0.0, share)), shown_(shown) {}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

double Progress::rate(const Tally& tally) const {
  return static_cast<double>(tally.lines() - kept_) / std::max(seconds(), 1e-6);
}

void Progress::show(const Tally& tally, double share) {
  if (!shown_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(200);
  const long lines = std::max(1L, tally.lines());
  std::string text = fmt::format("{} puzzles", grouped(tally.lines()));
  if (share >= 0) text += fmt::format("  {:.0f} %", 100 * share);
  text += fmt::format("  {}/s", grouped(static_cast<long>(rate(tally))));
  if (share > share_before_) text += fmt::format("  {} left", clock(seconds() * (1 - share) / (share - share_before_)));
  text += fmt::format("  solved {:.1f} %", 100 * static_cast<double>(tally.solved) / static_cast<double>(lines));
  say("\r" + text + "\033[K");
  drawn_ = true;
}

void Progress::clear() {
  if (drawn_) say("\r\033[K");
  drawn_ = false;
}

std::string grouped(long n) {
  std::string digits = std::to_string(n);
  for (auto i = static_cast<long>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), 1, ',');
  return digits;
}

std::string closing_line(const Tally& t, long kept, const Progress& progress) {
  std::string text = fmt::format("{} puzzle{}", grouped(t.lines()), t.lines() == 1 ? "" : "s");
  if (kept > 0) text += fmt::format(", {} of them kept,", grouped(kept));
  text += fmt::format(" in {:.3g} s, {} a second: {} solved", progress.seconds(),
                      grouped(static_cast<long>(progress.rate(t))), grouped(t.solved));
  text += fmt::format(", {} no-shot", grouped(t.no_shot));
  if (t.budget > 0) text += fmt::format(", {} out of budget", grouped(t.budget));
  text += fmt::format(", {} invalid", grouped(t.invalid));
  if (t.invalid > 0) text += fmt::format(" (the first on line {})", t.first_invalid);
  if (t.solved > 0) text += fmt::format("; worst miss {:.2g} m", t.worst_miss);
  if (t.beside > 0) text += fmt::format(", {} beside the target's centre", grouped(t.beside));
  return text + "\n";
}

std::string cost_csv(const Cost& c, const Tally& t, long kept, const Progress& progress) {
  const double each = 1e6 / static_cast<double>(std::max(1L, t.lines() - kept));
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return fmt::format(
      "puzzles,solved,seconds,puzzles_per_second,simulations,cpu_us_each,read_us,parse_us,search_us,certify_us,"
      "robustness_us,format_us,write_us,peak_mb\n"
      "{},{},{:.3f},{:.0f},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.1f}\n",
      t.lines() - kept, t.solved, progress.seconds(), progress.rate(t), t.simulations,
      each * (c.read + c.parse + c.search + c.certify + c.robustness + c.format + c.write), each * c.read,
      each * c.parse, each * c.search, each * c.certify, each * c.robustness, each * c.format, each * c.write,
      static_cast<double>(use.ru_maxrss) / 1024);
}

}  // namespace bankshot::app::batch
