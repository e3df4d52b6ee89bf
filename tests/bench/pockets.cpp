// SPDX-License-Identifier: MIT
//
// Random shots that drop, each turned into a puzzle that therefore has a shot. The puzzle gives the pocket, the number
// of cushions or their route, and the speed at which the ball fell. Prints a row for the kind of pockets: how many
// puzzles are solved, on the exact line or otherwise, and at what cost. Unsolved puzzles go to standard error.
//   pockets --count 100000 --jaws --physics spin
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/random_drop.hpp"

using namespace bankshot;

int main(int argc, char** argv) {
  CLI::App app("Random shots that drop, as puzzles");
  long count = 1000;
  std::uint64_t seed = 1;
  std::string physics = "spin";
  int cushions = 5;
  bool jaws = false, header = false;
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--physics", physics)->check(CLI::IsMember({"rolling", "spin"}))->capture_default_str();
  app.add_option("--cushions", cushions, "At most")->capture_default_str();
  app.add_flag("--jaws", jaws);
  app.add_flag("--header", header);
  CLI11_PARSE(app, argc, argv);
  long solved = 0, offset = 0, beside = 0, rattling = 0, simulations = 0, from_jaw_shot = 0, lost = 0, lost_clean = 0,
       lost_at_the_end = 0;
  double us = 0;
  for (long i = 0; i < count; ++i) {
    test::Random random(seed, static_cast<std::uint64_t>(i));
    const test::Drop d = test::random_drop(random, jaws, physics == "spin", cushions);
    const Answer a = solve(d.puzzle, {.robustness = false, .suggest = false});
    simulations += a.simulations;
    us += a.time_us;
    from_jaw_shot += d.touches_jaws();
    if (a.shots.empty()) {
      ++lost;
      lost_clean += !d.touches_jaws();
      lost_at_the_end += d.touches_jaws() && d.only_at_the_end();
      std::cerr << write_puzzle(d.puzzle) << (d.touches_jaws() ? " by a rattle\n" : "\n");
      continue;
    }
    const Shot& shot = a.shots.front();
    ++solved;
    offset += shot.verification.offset != 0 && !shot.verification.off_centre;
    beside += shot.verification.off_centre && !shot.path.touches_jaws;
    rattling += shot.path.touches_jaws;
  }
  if (header)
    std::cout << "pockets,physics,seed,puzzles,by_rattle,solved,unsolved,unsolved_clean,unsolved_at_the_end,offset,"
                 "beside,rattles,simulations,us\n";
  std::cout << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{:.1f},{:.1f}\n", jaws ? "jaws" : "circles", physics,
                           seed, count, from_jaw_shot, solved, lost, lost_clean, lost_at_the_end, offset, beside,
                           rattling, static_cast<double>(simulations) / static_cast<double>(count),
                           us / static_cast<double>(count));
  return lost_clean > 0 ? 1 : 0;
}
