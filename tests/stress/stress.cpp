// SPDX-License-Identifier: MIT
//
// Solves random puzzles that have a shot and checks every answer by an independent replay.
//   stress --count 100000 --seed 1 --physics rolling --family all [--planner auto] [--all] [--csv] [--progress]
//   stress --family list
// Prints one line per family (--csv: comma-separated, with the failures on standard error). Each failure is printed as
// JSON that `bankshot solve` replays. A puzzle is plain if the shot it was made from has κ < 1e6
// (simulate/simulator.hpp, property 6) and keeps its cushions when the aim turns by 1e-9 rad; otherwise it is hard.
// Exit 1 if a plain puzzle is not solved or more than one in a thousand of the hard ones is not. Exit 1 also if a plain
// puzzle that has a shot at the centre is answered beside it, if an answer is wrong, or if one spends more than its
// budget and one path. With --all and nothing left free, the shot that a plain puzzle was made from must be among all.
// With --force, every shot that brute force finds must be, too (support/root_map.hpp). --verify checks each answer in
// 50 digits.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <map>
#include <numeric>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/families.hpp"
#include "support/made.hpp"
#include "support/replay_check.hpp"
#include "support/root_map.hpp"
#include "truth/claims.hpp"

namespace {

using namespace bankshot;

struct Tally {
  long puzzles = 0, solved = 0, hard = 0, unsolved = 0, hard_unsolved = 0, off_centre = 0, wrong = 0, corners = 0,
       simulations = 0;
  long point_off = 0, hard_point_off = 0;  ///< solved, but beside the centre: plain ones, hard ones
  long over_budget = 0, lost = 0, hard_lost = 0;
  long forced = 0, missing = 0;  ///< shots that brute force finds, and those that --all lacks
  double worst_miss = 0;         // fraction of the diagonal
  double worst_speed = 0;
  std::vector<double> us{};  ///< of each solve
  /// Returns the time within which this share of the solves stays [us].
  double us_within(double share) {
    if (us.empty()) return 0;
    const auto nth = us.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(us.size() - 1));
    std::ranges::nth_element(us, nth);
    return *nth;
  }

  std::map<std::string, long> found_by{};  ///< the step that found the best shot
  std::string steps() const {
    std::string out;
    for (const auto& [step, times] : found_by) out += fmt::format("{}{} {}", out.empty() ? "" : "; ", step, times);
    return out;
  }
  long plain_unsolved() const { return unsolved - hard_unsolved; }
  bool clean() const {
    return plain_unsolved() == 0 && point_off == 0 && wrong == 0 && over_budget == 0 && lost == 0 && missing == 0 &&
           hard_unsolved <= std::max(1L, hard / 1000);
  }
};

/// Turn of the aim that reveals a path through a corner, twice the margin of is_hard [rad].
constexpr double beside_corner = 2e-9;

/// The kind of puzzles, the options of the solve, and the checks of its answer.
struct Way {
  const test::NamedFamily& family;
  test::Model model;
  int bounces;
  SolveOptions options;
  bool verify = false, force = false;
};

/// One puzzle, and the checks of its answer.
class Case {
 public:
  Case(const Way& way, test::Random& random, std::ostream& failures, Tally& tally)
      : way_(way),
        made_(way.family.make(random, way.model, way.bounces)),
        hard_(test::is_hard(made_)),
        failures_(failures),
        t_(tally) {
    ++t_.puzzles;
    t_.hard += hard_;
  }

  void run(bool all) {
    SolveOptions options = way_.options;
    options.all = all;
    const auto begin = std::chrono::steady_clock::now();
    const Answer a = solve(made_.puzzle, options);
    t_.us.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    t_.simulations += a.simulations;
    if (a.simulations > budget_of(made_.puzzle) + 1) {
      ++t_.over_budget;
      report(fmt::format("{}spends {} simulations of {}", all ? "--all " : "", a.simulations, budget_of(made_.puzzle)));
    }
    if (way_.verify) verify(a);
    if (a.status != Status::solved) {
      if (!way_.family.solvable) return;
      t_.hard_unsolved += hard_;
      ++t_.unsolved;
      t_.corners += test::through_corner(made_, beside_corner);
      return report(a.message);
    }
    ++t_.solved;
    best(a.shots.front());
    for (const Shot& shot : a.shots) check(shot);
    if (all && way_.family.solvable && test::nothing_free(made_)) completeness(a.shots);
  }

 private:
  void best(const Shot& shot) {
    ++t_.found_by[std::string(shot.provenance.planner)];
    const double miss = shot.verification.miss / made_.puzzle.table.diagonal();
    if (miss <= 1e-9) {
      t_.worst_miss = std::max(t_.worst_miss, miss);
      return;
    }
    ++t_.off_centre;
    if (!way_.family.solvable || !test::is_exact(made_)) return;
    const bool excused = hard_ || test::through_corner(made_, beside_corner);
    ++(excused ? t_.hard_point_off : t_.point_off);
    if (!excused) report(fmt::format("miss {:.3g} of the diagonal", miss));
  }

  void check(const Shot& shot) {
    const test::Checked c = test::check_shot(made_.puzzle, shot);
    if (!c.problem.empty()) wrong(c.problem);
    t_.worst_speed = std::max(t_.worst_speed, c.speed_error);
  }

  void completeness(const std::vector<Shot>& all) {
    if (!test::is_among(made_.launch, all)) {
      ++(hard_ ? t_.hard_lost : t_.lost);
      if (!hard_) report("the shot it was made from is not among all");
    }
    if (!way_.force) return;
    const Puzzle& p = made_.puzzle;
    const double arrival = arrival_range(p).value_or(Range{0, 0}).low;
    long flights = 0;
    for (const test::Root& r :
         test::roots_on_grid(test::Aimed(p), p.spin, {arrival}, {.aim = radians(0.05)}, flights)) {
      ++t_.forced;
      if (test::is_among(r.launch, all)) continue;
      ++t_.missing;
      report(fmt::format("all lack {} m/s at {} degrees", r.launch.speed, degrees(r.launch.angle)));
    }
  }

  void verify(const Answer& a) {
    for (const truth::Check& c : truth::check(&made_.puzzle, made_.puzzle.id, a))
      if (!c.holds())
        return wrong(
            fmt::format("{} does not hold: off {}, allowed {} {}", truth::name(c.claim), c.off, c.allowed, c.what));
  }

  void wrong(const std::string& what) {
    ++t_.wrong;
    report(what);
  }

  void report(const std::string& what) const {
    failures_ << fmt::format("FAILED {} {}: {} (made from {} m/s at {} degrees, {} bounces)\n{}\n", way_.family.name,
                             hard_ ? "(hard)" : "(plain)", what, made_.launch.speed, degrees(made_.launch.angle),
                             made_.bounces, write_puzzle(made_.puzzle))
              << std::flush;
  }

  const Way& way_;
  test::Made made_;
  bool hard_;
  std::ostream& failures_;
  Tally& t_;
};

void print(const Way& way, const std::string& physics, std::uint64_t seed, bool csv, Tally& t) {
  const auto out = [&](auto format) {
    std::cout << fmt::format(fmt::runtime(format), way.options.planner, physics, way.family.name, seed, t.puzzles,
                             t.solved, t.off_centre, t.corners, t.wrong, t.worst_miss, t.worst_speed,
                             static_cast<double>(t.simulations) / static_cast<double>(t.puzzles),
                             std::reduce(t.us.begin(), t.us.end()) / static_cast<double>(t.puzzles), t.us_within(0.5),
                             t.us_within(0.99), t.plain_unsolved(), t.hard, t.hard_unsolved, t.point_off,
                             t.hard_point_off, t.over_budget, t.lost, t.hard_lost, t.forced, t.missing, t.steps());
  };
  out(csv ? "{},{},{},{},{},{},{},{},{},{:.2g},{:.2g},{:.1f},{:.1f},{:.1f},{:.1f},{},{},{},{},{},{},{},{},{},{},{}\n"
          : "{} {:8} {:8} seed {}: {} puzzles, {} solved ({} beside the centre), {} unsolved through a "
            "corner, {} wrong, worst miss {:.2g} of the "
            "diagonal, worst arrival speed {:.2g}, {:.1f} simulations and {:.1f} us each (half within {:.1f}, 99 % "
            "within {:.1f}); {} plain ones unsolved, "
            "of {} hard ones {}; beside a centre that has a shot {} plain ones, {} hard ones; over budget {}; not "
            "among "
            "all {} plain ones, {} hard ones; of {} shots by brute force {}; found by {}\n");
  std::cout << std::flush;
}

bool run(const Way& way, long count, std::uint64_t seed, bool progress, std::ostream& failures, Tally& t) {
  test::Random random(seed);
  for (long i = 0; i < count; ++i) {
    Case one(way, random, failures, t);
    one.run(way.options.all);
    if (!way.family.solvable) one.run(!way.options.all);
    if (progress && (i + 1) % std::max(1L, count / 100) == 0)
      std::cerr << fmt::format("{}: {} of {}, {} unsolved\n", way.family.name, i + 1, count, t.unsolved);
  }
  return t.clean();
}

/// Returns the families of a name; "all" are the four families of random_puzzle.hpp, a quarter of the puzzles each.
std::vector<const test::NamedFamily*> families(const std::string& name) {
  std::vector<const test::NamedFamily*> out;
  if (name == "all")
    for (const test::Family f : test::families) out.push_back(test::find_family(test::name(f)));
  else
    out.push_back(test::find_family(name));
  return out;
}

void list_families() {
  for (const test::NamedFamily& f : test::named_families()) std::cout << fmt::format("{:14} {}\n", f.name, f.summary);
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
      ->check(CLI::IsMember({"ideal", "rolling", "spin", "mathavan", "stronge", "tilted"}))
      ->capture_default_str();
  app.add_option("--family", family, "One family, all (the first four), or list")
      ->check([](const std::string& name) {
        const bool known = name == "all" || name == "list" || test::find_family(name);
        return known ? std::string() : "no such family; --family list names them";
      })
      ->capture_default_str();
  int bounces = -1;
  app.add_option("--cushions", bounces, "Exactly so many cushions; -1: as usual in the family")->capture_default_str();
  bool csv = false, progress = false, verify = false, force = false;
  app.add_flag("--csv", csv);
  app.add_flag("--progress", progress, "Tell on standard error how far it is, a hundred times a family");
  app.add_flag("--all", options.all, "Ask for every shot, and look for the one that the puzzle was made from");
  app.add_flag("--force", force, "With --all: look for every shot that brute force finds (0.3 s a puzzle)");
  app.add_flag("--verify", verify, "Hold every answer against 50 digits, as bankshot verify does");
  app.add_option("--planner", options.planner)->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const test::Model model = physics == "ideal"     ? test::Model::ideal
                            : physics == "rolling" ? test::Model::rolling
                            : physics == "spin"    ? test::Model::spin
                            : physics == "stronge" ? test::Model::stronge
                            : physics == "tilted"  ? test::Model::tilted
                                                   : test::Model::mathavan;
  if (family == "list") {
    list_families();
    return 0;
  }
  bool clean = true;
  if (csv)
    std::cout << "planner,physics,family,seed,puzzles,solved,beside_centre,unsolved_through_corner,wrong,worst_miss_of_"
                 "diagonal,worst_speed_error,simulations_each,us_each,us_median,us_99,plain_unsolved,hard,hard_"
                 "unsolved,plain_beside,"
                 "hard_beside,over_budget,plain_lost,hard_lost,forced,missing,found_by\n";
  for (const test::NamedFamily* f : families(family)) {
    const Way way{*f, model, bounces, options, verify, force};
    Tally t;
    clean = run(way, family == "all" ? count / 4 : count, seed, progress, csv ? std::cerr : std::cout, t) && clean;
    print(way, physics, seed, csv, t);
  }
  return clean ? 0 : 1;
}
