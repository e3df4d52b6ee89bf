// SPDX-License-Identifier: MIT
//
// The tests of this folder loop over classes of cases. Each class must hold the number of cases that its test expects,
// and every class must have a test.
#include <map>

#include "support/catch.hpp"
#include "truth/hard_cases.hpp"

using namespace bankshot;

TEST_CASE("the classes of hard cases hold what their tests speak of") {
  const std::map<std::string_view, std::size_t> shots{{"grazing", 72},
                                                      {"corners", 39},
                                                      {"frozen to a cushion", 500},
                                                      {"curving back", 28},
                                                      {"slip near 0", 40},
                                                      {"slide ends at a bounce", 41},
                                                      {"endless bouncing", 45},
                                                      {"speeds", 144},
                                                      {"tables", 22},
                                                      {"many bounces", 4},
                                                      {"many bounces with spin", 3},
                                                      {"reflex vertices", 243},
                                                      {"grazing a reflex vertex", 24},
                                                      {"friction by speed", 60},
                                                      {"integrated impacts", 112}};
  CHECK(truth::hard_classes().size() == shots.size());
  for (const auto& [name, count] : shots) {
    INFO(name);
    CHECK(truth::hard_cases(name).size() == count);
  }
  const std::map<std::string_view, std::size_t> puzzles{
      {"targets on cushions", 35}, {"target at the start", 6}, {"edge of the speed bound", 8}, {"folds", 4}};
  CHECK(truth::hard_puzzle_classes().size() == puzzles.size());
  for (const auto& [name, count] : puzzles) {
    INFO(name);
    CHECK(truth::hard_puzzles(name).size() == count);
  }
}
