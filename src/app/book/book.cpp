// SPDX-License-Identifier: MIT
//
// bankshot book: a page of puzzles, with the questions in front and the answers at the back.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "app/book/pages.hpp"
#include "app/book/words.hpp"
#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/line_file.hpp"
#include "app/option_checks.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "io/answer/words.hpp"

namespace bankshot::app::book {
namespace {

struct Arguments {
  std::string file, page;
};

std::vector<Puzzle> read_all(const std::string& file) {
  LineFile in(file);
  std::vector<Puzzle> puzzles;
  for (std::string line; in.next(line);) try {
      puzzles.push_back(read_puzzle(line));
    } catch (const InvalidInput& e) {
      throw FileError(fmt::format("{}:{}: {}{}{}", in.name, in.number, e.path, e.path.empty() ? "" : ": ", e.what()));
    }
  if (puzzles.empty()) throw FileError(in.name + ": there is no puzzle");
  return puzzles;
}

Entry entry(const Puzzle& puzzle) {
  const Answer answer = bankshot::solve(puzzle);
  Entry e{.solved = answer.status == Status::solved,
          .title = title(puzzle),
          .question = question(puzzle),
          .scene = scene(puzzle),
          .answer = answer.message,
          .asked = draw(puzzle, Answer{}, {.words = false}),
          .told = draw(puzzle, answer, {.words = false})};
  if (!e.solved) return e;
  const Shot& shot = answer.shots.front();
  e.difficulty = difficulty(shot);
  e.unique = bankshot::solve(puzzle, {.all = true, .robustness = false, .suggest = false}).shots.size() == 1;
  e.answer = fmt::format("{:.2f}°, {:.2f} m/s, success {}", degrees(shot.launch.angle), shot.launch.speed,
                         success_words(shot));
  return e;
}

std::string page_name(const std::string& path) {
  if (std::string bad = file_name(path); !bad.empty()) return bad;
  const std::string_view name = unpacked_name(path);
  return name.ends_with(".html") || name.ends_with(".svg") ? "" : "\"" + path + "\" must end in .html or .svg";
}

int run(const Arguments& a) {
  const std::vector<Puzzle> puzzles = read_all(a.file);
  write_file(a.page, "");  // reports a name that cannot be written before the work begins
  std::vector<Entry> book(puzzles.size());
  tbb::parallel_for(std::size_t{0}, book.size(), [&](std::size_t i) { book[i] = entry(puzzles[i]); });
  write_file(a.page, unpacked_name(a.page).ends_with(".svg") ? svg(book) : html(book));
  const auto solved = std::count_if(book.begin(), book.end(), [](const Entry& e) { return e.solved; });
  std::string told = fmt::format("{} puzzle{}, {} solved\n", book.size(), book.size() == 1 ? "" : "s", solved);
  for (const Part& part : parts(book, 1)) told += fmt::format("  {}: {}\n", part.title, part.subtitle);
  print(told);
  return solved ? done : nothing_solved;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("book", "Make a page of puzzles: questions in front, answers at the back");
  command->add_option("puzzles", a->file, "A puzzle in JSON on each line; - reads standard input")->required();
  command->add_option("-o,--output", a->page, "Write the page to this file, .html or .svg")
      ->required()
      ->check(page_name);
  explain(
      *command,
      "The page has all puzzles in their order. Headings say how hard the puzzles are (see `bankshot help generate`)\n"
      "and which have one answer. If the \"about\" of a puzzle holds a \"title\", that is its heading.",
      {{"bankshot book puzzles.jsonl -o book.html", "a page for a browser or a printer"},
       {"bankshot book puzzles.jsonl -o book.svg", "one large picture"}},
      "0 done; 1 no puzzle was solved; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::book
