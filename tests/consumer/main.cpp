// SPDX-License-Identifier: MIT
#include <bankshot/draw/svg.hpp>
#include <bankshot/plan/planner.hpp>
#include <bankshot/scene/json.hpp>
#include <cstdio>

int main() {
  using namespace bankshot;
  const Puzzle puzzle = read_puzzle(
      R"({"table": "seed", "physics": "rolling", "ball": {"at": [0.5, 0.5]}, "target": {"point": [2, 1]}, "cushions": 1})");
  const Answer answer = solve(puzzle);
  std::printf("%s %zu\n", name(answer.status), draw(puzzle, answer).size());
  return answer.status == Status::solved ? 0 : 1;
}
