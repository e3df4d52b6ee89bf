// SPDX-License-Identifier: MIT
//
// Solves random puzzles that have a shot and checks every answer with a replay of its own.
//   stress --count 100000 --seed 1 --physics rolling --family all [--planner auto] [--csv] [--progress]
// Prints a line a family (--csv: comma-separated, with the failures on standard error); each failure prints as JSON
// that `bankshot solve` replays. Puzzles are plain or hard: plain where the shot it was made from has κ < 1e6
// (simulate/simulator.hpp, property 6) and keeps its cushions when the aim turns by 1e-9 rad. Exit 1 if a plain one is
// not solved, more than one in a thousand of the hard ones, if the answer to a plain one that asks for a point is off
// centre, or any answer is wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <map>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"
#include "support/replay_check.hpp"
#include "support/truth.hpp"

namespace {

using namespace bankshot;

struct Tally {
  long puzzles = 0, solved = 0, hard = 0, hard_unsolved = 0, off_centre = 0, wrong = 0, corners = 0, simulations = 0;
  long point_off = 0, hard_point_off = 0;  ///< solved, but beside the point asked; of the plain ones, of the hard ones
  double worst_miss = 0;                   // of the diagonal
  double worst_speed = 0, us = 0;

  std::map<std::string, long> found_by{};  ///< the step that found the best shot
  std::string steps() const {
    std::string out;
    for (const auto& [step, times] : found_by) out += fmt::format("{}{} {}", out.empty() ? "" : "; ", step, times);
    return out;
  }
  long plain_unsolved() const { return puzzles - solved - hard_unsolved; }
  bool clean() const {
    return plain_unsolved() == 0 && point_off == 0 && wrong == 0 && hard_unsolved <= std::max(1L, hard / 1000);
  }
};

/// The shot the puzzle was made from meets other cushions so many rad beside its aim: it runs through a
/// corner or exactly along a cushion, and rounding decides.
bool through_corner(const test::Made& made, double beside) {
  const auto sequence = [&](double turned) {
    ShotRequest r{.table = made.puzzle.table,
                  .physics = made.puzzle.physics,
                  .ball = made.puzzle.ball,
                  .launch = made.launch,
                  .spin = made.puzzle.spin};
    r.launch.angle = wrap_angle(r.launch.angle + turned);
    r.until.cushions = made.bounces + 1;
    std::vector<Contact> s = simulate(r).sequence();
    s.resize(std::min(s.size(), static_cast<std::size_t>(made.bounces)));
    return s;
  };
  return sequence(-beside) != sequence(0) || sequence(beside) != sequence(0);
}

/// κ of the shot the puzzle was made from, up to the event after its target.
double kappa(const test::Made& made) {
  const Puzzle& p = made.puzzle;
  const Boundary boundary(p.table, p.ball.body);
  const State<double> start =
      launched(p.ball.at, p.ball.body.radius, direction(made.launch.angle) * made.launch.speed, p.spin);
  return test::condition({.boundary = boundary, .physics = p.physics, .start = start, .cushions = made.bounces + 1})
      .kappa;
}

bool is_hard(const test::Made& made) {
  constexpr double steep = 1e6, margin = 1e-9;
  return kappa(made) >= steep || through_corner(made, margin);
}

/// Rad: what counts as a path through a corner, twice the margin.
constexpr double beside_corner = 2e-9;

void one(test::Random& random, test::Family family, test::Model model, int bounces, const SolveOptions& options,
         std::ostream& failures, Tally& t) {
  const test::Made made = test::random_puzzle(random, family, model, bounces);
  const auto begin = std::chrono::steady_clock::now();
  const Answer a = solve(made.puzzle, options);
  t.us += std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  const bool hard = is_hard(made);
  ++t.puzzles;
  t.hard += hard;
  t.simulations += a.simulations;
  const auto report = [&](const std::string& what) {
    failures << fmt::format("FAILED {} {}: {} (made from {} m/s at {} degrees, {} bounces)\n{}\n", test::name(family),
                            hard ? "(hard)" : "(plain)", what, made.launch.speed, degrees(made.launch.angle),
                            made.bounces, write_puzzle(made.puzzle))
             << std::flush;
  };
  if (a.status != Status::solved) {
    t.hard_unsolved += hard;
    if (through_corner(made, beside_corner)) ++t.corners;
    return report(a.message);
  }
  ++t.solved;
  const Shot& shot = a.shots.front();
  ++t.found_by[std::string(shot.planner)];
  const double miss = shot.miss / made.puzzle.table.diagonal();
  if (miss > 1e-9) {
    ++t.off_centre;
    if (!std::holds_alternative<PocketTarget>(made.puzzle.target)) {
      const bool excused = hard || through_corner(made, beside_corner);
      ++(excused ? t.hard_point_off : t.point_off);
      if (!excused) report(fmt::format("miss {:.3g} of the diagonal", miss));
    }
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
  app.add_option("--physics", physics)
      ->check(CLI::IsMember({"ideal", "rolling", "spin", "mathavan"}))
      ->capture_default_str();
  app.add_option("--family", family)
      ->check(CLI::IsMember({"all", "uniform", "discrete", "convex", "reflex"}))
      ->capture_default_str();
  int bounces = -1;
  app.add_option("--cushions", bounces, "Exactly so many cushions; -1: up to 5")->capture_default_str();
  bool csv = false, progress = false;
  app.add_flag("--csv", csv);
  app.add_flag("--progress", progress, "Tell on standard error how far it is, a hundred times a family");
  app.add_option("--planner", options.planner)->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const test::Model model = physics == "ideal"     ? test::Model::ideal
                            : physics == "rolling" ? test::Model::rolling
                            : physics == "spin"    ? test::Model::spin
                                                   : test::Model::mathavan;
  bool clean = true;
  if (csv)
    std::cout << "planner,physics,family,seed,puzzles,solved,beside_centre,unsolved_through_corner,wrong,worst_miss_of_"
                 "diagonal,worst_speed_error,simulations_each,us_each,plain_unsolved,hard,hard_unsolved,points_beside,"
                 "hard_points_beside,found_by\n";
  for (const test::Family f : test::families) {
    if (family != "all" && family != test::name(f)) continue;
    test::Random random(seed);
    Tally t;
    const long most = family == "all" ? count / 4 : count;
    for (long i = 0; i < most; ++i) {
      one(random, f, model, bounces, options, csv ? std::cerr : std::cout, t);
      if (progress && (i + 1) % std::max(1L, most / 100) == 0)
        std::cerr << fmt::format("{}: {} of {}, {} unsolved\n", test::name(f), i + 1, most, t.puzzles - t.solved);
    }
    const auto print = [&](auto format) {
      std::cout << fmt::format(fmt::runtime(format), options.planner, physics, test::name(f), seed, t.puzzles, t.solved,
                               t.off_centre, t.corners, t.wrong, t.worst_miss, t.worst_speed,
                               static_cast<double>(t.simulations) / static_cast<double>(t.puzzles),
                               t.us / static_cast<double>(t.puzzles), t.plain_unsolved(), t.hard, t.hard_unsolved,
                               t.point_off, t.hard_point_off, t.steps());
    };
    print(csv ? "{},{},{},{},{},{},{},{},{},{:.2g},{:.2g},{:.1f},{:.1f},{},{},{},{},{},{}\n"
              : "{} {:8} {:8} seed {}: {} puzzles, {} solved ({} beside the centre), {} unsolved through a "
                "corner, {} wrong, worst miss {:.2g} of the "
                "diagonal, worst arrival speed {:.2g}, {:.1f} simulations and {:.1f} us each; {} plain ones unsolved, "
                "of {} hard ones {}; beside a point asked {} plain ones, {} hard ones; found by {}\n");
    std::cout << std::flush;
    clean = clean && t.clean();
  }
  return clean ? 0 : 1;
}
