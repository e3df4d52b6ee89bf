// SPDX-License-Identifier: MIT
//
// "What should I play?": shots that the list must not leave out. Each layout is named by its shot. A longer comparison
// with brute force is tests/stress/play.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/lost_puzzles.hpp"

using namespace bankshot;

namespace {

/// Returns the name of a shot as ids are stored: in JSON.
std::string name_of(const Puzzle& p, const Shot& shot) {
  std::vector<std::string> by;
  for (const Contact c : shot.path.then.back().cushions) by.push_back(contact_name(p.table, c));
  const std::string& ball = p.others[static_cast<std::size_t>(shot.arriving()) - 1].id;
  return fmt::format(R"("ball {} into {} by [{}]")", ball, pocket_reached(p, shot)->name, fmt::join(by, ", "));
}

}  // namespace

TEST_CASE("what is made only between balls that move, or beside the exact line, is in the list") {
  const auto is_listed = [](const Puzzle& p, const Answer&) {
    std::vector<std::string> names;
    for (const Shot& shot : solve(p, {.all = true, .robustness = false, .suggest = false}).shots) {
      CHECK(test::check_shot(p, shot).problem.empty());
      names.push_back(name_of(p, shot));
    }
    CHECK_THAT(names, Catch::VectorContains(p.id));
  };
  CHECK(test::solve_lost_puzzles("tests/plan/listed.jsonl", is_listed) == 7);
}
