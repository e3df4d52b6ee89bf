// SPDX-License-Identifier: MIT
//
// Checks the book of puzzles: 100 puzzles of rising difficulty, all solved exactly, the last ten with one shot each.
#include <set>
#include <sstream>

#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

using namespace bankshot;

TEST_CASE("the book: 30 easy, 30 medium, 30 hard and 10 unique puzzles, each part from the surest shot to the least") {
  std::istringstream lines(test::read_repository_file("examples/puzzles/book.jsonl"));
  constexpr std::size_t part = 30;
  std::size_t number = 0;
  double before = 1;
  std::set<std::string> questions;
  for (std::string line; std::getline(lines, line); ++number) {
    INFO(line);
    Puzzle p = read_puzzle(line);
    p.aim = Aim::centre;  // the exact shot defines the difficulty of a puzzle
    CHECK(p.id == "\"book-" +
                      std::string(number < 9    ? "00"
                                  : number < 99 ? "0"
                                                : "") +
                      std::to_string(number + 1) + "\"");
    CHECK(questions.insert(line.substr(line.find("\"table\""))).second);
    const bool unique = number >= 3 * part;
    const Answer a = solve(p, {.all = unique});
    REQUIRE(a.status == Status::solved);
    CHECK(a.shots[0].verification.miss <= 1e-9 * p.table.diagonal());
    if (unique)
      CHECK(a.shots.size() == 1);
    else
      CHECK(difficulty(a.shots[0]) == static_cast<Difficulty>(number / part));
    if (number % part == 0) before = 1;
    CHECK(*a.shots[0].robustness.success <= before + tolerance::success);  // success has this tolerance
    before = *a.shots[0].robustness.success;
  }
  CHECK(number == 100);
}
