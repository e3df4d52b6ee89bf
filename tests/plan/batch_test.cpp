// SPDX-License-Identifier: MIT
//
// The C++ call for many puzzles gives the answers of `solve`, in order, for any number of threads.
#include "bankshot/plan/batch.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "planners/in_parallel.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

std::vector<Puzzle> some_puzzles() {
  test::Random random(11);
  std::vector<Puzzle> out;
  for (int i = 0; i < 60; ++i) {
    out.push_back(
        test::random_puzzle(random, test::families[i % 4], i % 3 ? test::Model::rolling : test::Model::spin).puzzle);
    out.back().id = std::to_string(i);
  }
  out[20].ball.at = {1e3, 0};
  out[40].budget = 0;
  return out;
}

}  // namespace

TEST_CASE("solve_batch gives the answers of solve in order for any number of threads") {
  const std::vector<Puzzle> puzzles = some_puzzles();
  for (const int threads : {0, 1, 2, 7, 1000}) {
    const std::vector<Answer> answers = solve_batch(puzzles, {.threads = threads});
    REQUIRE(answers.size() == puzzles.size());
    long simulations = 0;
    for (std::size_t i = 0; i < puzzles.size(); ++i) {
      simulations += answers[i].simulations;
      if (i != 20) CHECK(to_json(puzzles[i], answers[i], false) == to_json(puzzles[i], solve(puzzles[i]), false));
    }
    CHECK(answers[20].status == Status::invalid);
    CHECK(answers[20].error->path == "/ball/at");
    CHECK(answers[20].id == "20");
    CHECK(answers[40].status == Status::budget);
    CHECK(simulations > 60);
  }
}

TEST_CASE("solve_batch answers no puzzles with no answers and an unknown planner with invalid ones") {
  CHECK(solve_batch({}).empty());
  const std::vector<Answer> answers = solve_batch(some_puzzles(), {.solve = {.planner = "none"}, .threads = 2});
  for (const Answer& a : answers) CHECK(a.status == Status::invalid);
}

TEST_CASE("each index is taken once, by any number of threads") {
  for (const int threads : {0, 1, 3}) {
    std::vector<std::atomic<int>> taken(1000);
    planning::for_each_index(taken.size(), threads, [&](std::size_t i) { ++taken[i]; });
    CHECK(std::ranges::all_of(taken, [](const auto& n) { return n == 1; }));
    planning::for_each_index(0, threads, [](std::size_t) { FAIL("there is no index"); });
    const auto fail = [](std::size_t i) {
      if (i == 500) throw std::runtime_error("one index fails");
    };
    CHECK_THROWS_AS(planning::for_each_index(taken.size(), threads, fail), std::runtime_error);
  }
}

TEST_CASE("the costs that solve measures are parts of its time") {
  const Puzzle puzzle = some_puzzles()[1];
  const Answer a = solve(puzzle, {.measure = true});
  REQUIRE(a.status == Status::solved);
  CHECK(a.cost.certify_us > 0);
  CHECK(a.cost.certify_us < a.time_us);
  CHECK(a.cost.robustness_us > 0);
  CHECK(solve(puzzle).cost.certify_us == 0);
}
