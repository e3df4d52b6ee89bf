// SPDX-License-Identifier: MIT
//
// The answers to a file of puzzles, such as examples/puzzles/book.jsonl: a line each on standard output, and a page
// with all pictures. Its headings say what the file holds: how many puzzles, how hard (plan/generate.hpp), which have
// one answer. Exit 1 where a puzzle has no answer.
//   puzzle_book PUZZLES.jsonl PAGE.svg
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <span>

#include "bankshot/draw/page.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"

namespace {

using namespace bankshot;

std::string counted(int n) {
  constexpr const char* words[] = {"Straight",       "One cushion",   "Two cushions",
                                   "Three cushions", "Four cushions", "Five cushions"};
  return n < static_cast<int>(std::size(words)) ? words[n] : fmt::format("{} cushions", n);
}

std::string cushions(const Puzzle& p) {
  const CushionRule& rule = p.cushions;
  if (!rule.sequence)
    return rule.min == rule.max ? counted(rule.min) : fmt::format("{} to {} cushions", rule.min, rule.max);
  if (rule.sequence->empty()) return counted(0);
  std::string names;
  for (const Contact c : *rule.sequence) names += (names.empty() ? "By " : ", ") + contact_name(p.table, c);
  return names;
}

std::string question(const Puzzle& p) {
  const auto arrive = arrival_range(p);
  const std::string speed = p.speed.fixed() ? fmt::format(", struck at {:.2g} m/s", p.speed.low) : "";
  const bool rests = !is_pocket(p.target) && arrive && arrive->high == 0;
  const std::string asked = cushions(p) + (rests ? ", " : " ") + in_words(p.target, p.table, rests);
  if (is_pocket(p.target) || !arrive) return asked + speed;
  return rests ? asked : asked + fmt::format(" at {:.2g} m/s", arrive->low);
}

std::string scene(const Puzzle& p) {
  const Vec2d size = p.table.highest() - p.table.lowest();
  std::string out = p.table.is_rectangle() ? fmt::format("{:.3g} × {:.3g} m", size.x, size.y)
                                           : fmt::format("{} sides", p.table.vertices.size());
  for (const TablePreset& t : table_presets())
    if (make_table(t).vertices == p.table.vertices) out = t.name;
  out += is_ideal(p.physics)                                       ? ", no friction"
         : is_straight(p.physics)                                  ? ", rolling"
         : std::holds_alternative<Mathavan2010>(p.physics.cushion) ? ", spin after Mathavan"
                                                                   : ", spin";
  if (p.spin.top != 0) out += fmt::format(", top {:.2g}", p.spin.top);
  if (p.spin.side != 0) out += fmt::format(", side {:.2g}", p.spin.side);
  return out + (p.spin.masse != 0 ? fmt::format(", massé {:.2g}", p.spin.masse) : "");
}

/// What a heading may be made of.
struct Kind {
  bool solved = false, unique = false;
  Difficulty difficulty{};
};

struct Entry {
  Kind kind;
  Plate plate;
};

/// "9 easy, 1 hard"
std::string counts(std::span<const Entry> part) {
  std::string out;
  const auto add = [&](long n, const std::string& what) {
    if (n > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", n, what);
  };
  for (const Difficulty d : {Difficulty::easy, Difficulty::medium, Difficulty::hard})
    add(std::count_if(part.begin(), part.end(),
                      [&](const Entry& e) { return e.kind.solved && e.kind.difficulty == d; }),
        name(d));
  add(std::count_if(part.begin(), part.end(), [](const Entry& e) { return !e.kind.solved; }), "without an answer");
  return out;
}

/// What `difficulty` says of all of them (plan/generate.hpp), for the default player.
std::string meaning(Difficulty d) {
  if (d == Difficulty::easy)
    return fmt::format("made in at least {:.0f} % of tries, and {:.2g}° of aim to both sides still make it",
                       100 * easy_success, degrees(easy_margin));
  if (d == Difficulty::hard)
    return fmt::format("made in less than {:.0f} % of tries, or less than {:.3g}° of aim to one side",
                       100 * hard_success, degrees(hard_margin));
  return "between easy and hard";
}

template <class Same>
std::size_t run_length(std::span<const Entry> rest, Same same) {
  return static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), same) - rest.begin());
}

/// How many of the first belong together: of one difficulty, or with one answer each, whichever are more.
std::size_t alike(std::span<const Entry> rest) {
  const Kind& first = rest.front().kind;
  return std::max(run_length(rest, [](const Entry& e) { return e.kind.unique; }), run_length(rest, [&](const Entry& e) {
                    return e.kind.solved == first.solved && e.kind.difficulty == first.difficulty;
                  }));
}

/// The heading says what is true of all of them.
Chapter chapter(std::span<const Entry> part) {
  const auto n = part.size();
  const bool unique = run_length(part, [](const Entry& e) { return e.kind.unique; }) == n;
  Chapter out{fmt::format("{} puzzle{}", n, n == 1 ? "" : "s"), counts(part), {}};
  if (unique)
    out = {fmt::format("{} with one answer", n), "no other was found: " + counts(part), {}};
  else if (part.front().kind.solved && alike(part) == n)
    out = {counts(part), meaning(part.front().kind.difficulty), {}};
  for (const Entry& e : part) out.plates.push_back(e.plate);
  return out;
}

/// In the file's order. What is shorter than a row of the page joins the chapter before it.
std::vector<Chapter> chapters(std::span<const Entry> book, std::size_t row) {
  std::vector<std::size_t> ends;
  for (std::size_t begin = 0; begin < book.size();) {
    const std::size_t n = alike(book.subspan(begin));
    begin += n;
    if (n < row && !ends.empty())
      ends.back() = begin;
    else
      ends.push_back(begin);
  }
  std::vector<Chapter> out;
  std::size_t begin = 0;
  for (const std::size_t end : ends) out.push_back(chapter(book.subspan(begin, end - begin))), begin = end;
  return out;
}

/// Solves a puzzle, prints its line and draws it.
Entry entry(const Puzzle& puzzle, std::size_t number) {
  const Answer answer = solve(puzzle);
  Kind kind{.solved = answer.status == Status::solved};
  std::string told = answer.message;
  if (kind.solved) {
    const Shot& shot = answer.shots.front();
    kind.difficulty = difficulty(shot);
    kind.unique = solve(puzzle, {.all = true, .robustness = false, .suggest = false}).shots.size() == 1;
    told = fmt::format("{:.2f}°, {:.2f} m/s, chance {:.0f} %", degrees(shot.launch.angle), shot.launch.speed,
                       100 * *shot.success);
  }
  fmt::print("{:3}  {:<32} {}\n", number, told, question(puzzle));
  return {kind,
          {draw(puzzle, answer, {.words = false}), fmt::format("{}", number), {question(puzzle), scene(puzzle), told}}};
}

int make_book(const char* puzzles, const char* page) {
  std::vector<Entry> book;
  std::ifstream in(puzzles);
  for (std::string line; std::getline(in, line);) try {
      book.push_back(entry(read_puzzle(line), book.size() + 1));
    } catch (const InvalidInput& e) {
      fmt::print(stderr, "{}:{}: {}: {}\n", puzzles, book.size() + 1, e.path, e.what());
      return 2;
    }
  const auto solved = std::count_if(book.begin(), book.end(), [](const Entry& e) { return e.kind.solved; });
  const bool all = solved == static_cast<long>(book.size());
  const PageStyle style{.columns = 5,
                        .plate = 480,
                        .ratio = 0.6,
                        .letter = 18,
                        .title = fmt::format("{} Puzzles", book.size()),
                        .subtitle = (all ? "every answer" : fmt::format("{} answers", solved)) +
                                    std::string(" found by bankshot and proved by a forward simulation")};
  std::ofstream out(page);
  out << draw_page(chapters(book, static_cast<std::size_t>(style.columns)), style) << std::flush;
  if (!out) return fmt::print(stderr, "{}: cannot be written\n", page), 2;
  return all ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fmt::print(stderr, "usage: puzzle_book PUZZLES.jsonl PAGE.svg\n"), 2;
  return make_book(argv[1], argv[2]);
}
