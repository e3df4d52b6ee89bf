// SPDX-License-Identifier: MIT
//
// Solves random puzzles that have a shot and checks every answer with a replay of its own.
//   stress --count 100000 --seed 1 --physics rolling --family all [--planner auto] [--csv]
// Prints a line a family (--csv: comma-separated); each failure prints as JSON that `bankshot solve` replays. Exit 1 if any.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"
#include "support/replay_check.hpp"

namespace {

using namespace bankshot;

struct Tally {
  long puzzles = 0, solved = 0, off_centre = 0, wrong = 0, corners = 0, simulations = 0;
  double worst_miss = 0;  // of the diagonal
  double worst_speed = 0;
};

/// The shot the puzzle was made from meets other cushions 2e-9 rad beside its aim: it runs through a
/// corner or exactly along a cushion, and rounding decides. Such a puzzle may fail; it is counted.
bool through_corner(const test::Made& made) {
  const auto sequence = [&](double turned) {
    ShotRequest r{.table = made.puzzle.table,
                  .physics = made.puzzle.physics,
                  .ball = made.puzzle.ball,
                  .launch = made.launch,
                  .spin = made.puzzle.spin};
    r.launch.angle = wrap_angle(r.launch.angle + turned);
    r.until.cushions = made.bounces + 1;
    std::vector<int> s = simulate(r).sequence();
    s.resize(std::min(s.size(), static_cast<std::size_t>(made.bounces)));
    return s;
  };
  return sequence(-2e-9) != sequence(0) || sequence(2e-9) != sequence(0);
}

void one(test::Random& random, test::Family family, test::Model model, int bounces, const SolveOptions& options, Tally& t) {
  const test::Made made = test::random_puzzle(random, family, model, bounces);
  const Answer a = solve(made.puzzle, options);
  ++t.puzzles;
  t.simulations += a.simulations;
  const auto report = [&](const std::string& what) {
    std::cout << fmt::format("FAILED {}: {} (made from {} m/s at {} degrees, {} bounces)\n{}\n", test::name(family), what,
                             made.launch.speed, degrees(made.launch.angle), made.bounces, write_puzzle(made.puzzle));
  };
  if (a.status != Status::solved) {
    if (through_corner(made)) ++t.corners;
    return report(a.message);
  }
  ++t.solved;
  const Shot& shot = a.shots.front();
  const double miss = shot.miss / made.puzzle.table.diagonal();
  if (miss > 1e-9) {
    ++t.off_centre;
    if (!std::holds_alternative<PocketTarget>(made.puzzle.target) && !through_corner(made))
      report(fmt::format("miss {:.3g} of the diagonal", miss));
  } else {
    t.worst_miss = std::max(t.worst_miss, miss);
  }
  const test::Checked c = test::check_shot(made.puzzle, shot);
  if (!c.problem.empty()) {
    ++t.wrong;
    report(c.problem);
  }
  t.worst_speed = std::max(t.worst_speed, c.speed_error);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random puzzles that have a shot: are they all solved?");
  long count = 1000;
  std::uint64_t seed = 1;
  std::string physics = "rolling", family = "all";
  SolveOptions options{.robustness = false, .suggest = false};
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--physics", physics)->check(CLI::IsMember({"ideal", "rolling", "spin", "mathavan"}))->capture_default_str();
  app.add_option("--family", family)->check(CLI::IsMember({"all", "uniform", "discrete", "convex", "reflex"}))->capture_default_str();
  int bounces = -1;
  app.add_option("--cushions", bounces, "Exactly so many cushions; -1: up to 5")->capture_default_str();
  bool csv = false;
  app.add_flag("--csv", csv);
  app.add_option("--planner", options.planner)->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const test::Model model = physics == "ideal"     ? test::Model::ideal
                            : physics == "rolling" ? test::Model::rolling
                            : physics == "spin"    ? test::Model::spin
                                                   : test::Model::mathavan;
  bool clean = true;
  if (csv)
    std::cout << "planner,physics,family,seed,puzzles,solved,beside_centre,unsolved_through_corner,wrong,worst_miss_of_"
                 "diagonal,worst_speed_error,simulations_each,us_each\n";
  for (const test::Family f : test::families) {
    if (family != "all" && family != test::name(f)) continue;
    test::Random random(seed);
    Tally t;
    const auto begin = std::chrono::steady_clock::now();
    for (long i = 0; i < (family == "all" ? count / 4 : count); ++i) one(random, f, model, bounces, options, t);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    const auto print = [&](auto format) {
      std::cout << fmt::format(fmt::runtime(format), options.planner, physics, test::name(f), seed, t.puzzles, t.solved,
                               t.off_centre, t.corners, t.wrong, t.worst_miss, t.worst_speed,
                               static_cast<double>(t.simulations) / static_cast<double>(t.puzzles),
                               took.count() / static_cast<double>(t.puzzles));
    };
    print(csv ? "{},{},{},{},{},{},{},{},{},{:.2g},{:.2g},{:.1f},{:.1f}\n"
              : "{} {:8} {:8} seed {}: {} puzzles, {} solved ({} beside the pocket's centre), {} unsolved through a "
                "corner, {} wrong, worst miss {:.2g} of the "
                "diagonal, worst arrival speed {:.2g}, {:.1f} simulations and {:.1f} us each\n");
    clean = clean && t.solved + t.corners == t.puzzles && t.wrong == 0;
  }
  return clean ? 0 : 1;
}
