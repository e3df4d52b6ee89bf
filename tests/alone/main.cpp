// SPDX-License-Identifier: MIT
#include <bankshot/plan/planner.hpp>
#include <bankshot/scene/json.hpp>
#include <cstdio>
#include <string>

int main() {
  using namespace bankshot;
  for (const PlannerInfo& p : planners())
    if (std::string(p.name).find("nlopt") != std::string::npos ||
        std::string(p.summary).find("nlopt") != std::string::npos)
      return std::printf("%s is listed\n", std::string(p.name).c_str()), 1;
  // The second puzzle has no shot, so `auto` tries all its steps.
  const Answer
      bank = solve(read_puzzle(
          R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"point": [1.9, 0.9]}, "cushions": 2})")),
      none = solve(read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"point": [1.9, 0.9]},)"
                               R"( "cushions": ["top", "top", "top"]})"));
  std::printf("%s; %s: %s\n", name(bank.status), name(none.status), none.message.c_str());
  return bank.status == Status::solved && none.status == Status::no_shot ? 0 : 1;
}
