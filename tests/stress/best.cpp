// SPDX-License-Identifier: MIT
//
// Compares `solve`, the first shot of `solve --all` and brute force (support/by_force.hpp) on random puzzles. The cases
// differ in what `prefer` asks and in what is left free: nothing, the arrival speed, that speed within an aim window,
// the spin, or spin and arrival speed.
//   best --count 1000 --seed 1 --physics spin --free arrive --prefer soft [--aim-step 0.02] [--no-force] [--worst 5]
// Tables are 2.54 m x 1.27 m without pockets, or 9-foot ones with them. A puzzle asks for 0 to 3 cushions, or for
// exactly 1 to 3; it is made from a simulated shot, so each has one. Prints CSV, tests/bench/results/best.csv:
//   unsolved_*    no shot; beside_*: only a shot beside the centre, where brute force has one at the centre
//   solve_worse   solve is worse than --all by more than 0.5 % of speed or time, or 0.005 of success (20,000 draws)
//   *_far_*       worse by more than 10 %, or 0.1 of success
//   silent        cases of solve_worse in which the message does not say that there may be a better shot
//   *_below_force the same against brute force
//   force_worse   brute force is worse than --all, so it missed that shot
//   all_climbs    a pattern search that begins at the first shot of --all gets better by as much: no local optimum
//   us_*          CPU time per puzzle; with robust, the time for the success of the candidates is included
// The worst cases are printed on standard error as JSON that `bankshot solve` replays. Exit 0, as it only measures.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "app/clock.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/by_force.hpp"
#include "support/forward.hpp"

namespace {

using namespace bankshot;

constexpr const char* frees[] = {"nothing", "arrive", "window", "spin", "both"};
constexpr const char* prefers[] = {"robust", "soft", "quick"};

test::Made plain_case(test::Random& r, test::Model model) {
  test::Made m = test::ask_for_some(r, -1, 3, [&] {
    ShotRequest shot = test::usual_shot(r, model);
    const bool pockets = !shot.table.pockets.empty();
    const bool common = pockets || shot.table.diagonal() == rectangle_table(2.54, 1.27).diagonal();
    return common ? std::optional(shot) : std::nullopt;
  });
  Puzzle& p = m.puzzle;
  p.cushions = m.bounces == 0 || r.chance(0.5) ? CushionRule{0, 3, {}} : CushionRule::exactly(m.bounces);
  return m;
}

Range around(test::Random& r, double v, double down, double up) {
  return {v - down * r.uniform(0, 1), v + up * r.uniform(0, 1)};
}

test::Made random_case(test::Random& r, test::Model model, const std::string& free, Prefer prefer) {
  return test::first_valid([&]() -> std::optional<test::Made> {
    test::Made m = plain_case(r, model);
    Puzzle& p = m.puzzle;
    p.prefer = prefer;
    const bool arrives = free == "arrive" || free == "window" || free == "both";
    if (arrives && !p.arrive) return {};
    if (arrives) p.arrive = around(r, p.arrive->low, p.arrive->low * 0.9, 2 * p.arrive->low);
    if (!p.speed.fixed()) p.speed = {0.1, 10};
    if (free == "window") {
      const double before = r.log_uniform(1e-2, 1);
      p.angle = Range{wrap_angle(m.launch.angle - before), 0};
      p.angle->high = p.angle->low + before + r.log_uniform(1e-2, 1);
    }
    if (free == "spin" || free == "both")
      p.spin_range =
          SpinRange{around(r, p.spin.top, 0.8, 0.8), around(r, p.spin.side, 0.8, 0.8), {p.spin.masse, p.spin.masse}};
    return m;
  });
}

/// The shot of one of the three methods.
struct Contender {
  Launch launch;
  LaunchSpin spin;
  double time, chance = 0;
};

/// Returns by how much `a` is worse than `b`, in speed or time (relative), or in success.
double worse(Prefer prefer, const Contender& a, const Contender& b) {
  if (prefer == Prefer::soft) return a.launch.speed / b.launch.speed - 1;
  if (prefer == Prefer::quick) return a.time / b.time - 1;
  return b.chance - a.chance;
}

struct Count {
  long worse = 0, far = 0;
  bool add(double by) {
    constexpr double little = 0.005, much = 0.1;
    worse += by > little;
    far += by > much;
    return by > little;
  }
};

struct Tally {
  long puzzles = 0, unsolved_solve = 0, unsolved_all = 0, beside_solve = 0, beside_all = 0, silent = 0, no_force = 0;
  Count solve, solve_below_force, all_below_force, force, climbs;
  double simulations_solve = 0, simulations_all = 0, simulations_force = 0;
  double us_solve = 0, us_all = 0, us_force = 0;
  std::vector<std::pair<double, std::string>> cases{};  ///< the worst ones, with the amount
};

struct Way {
  test::Model model;
  std::string free;
  Prefer prefer;
  bool force;
  test::Fineness fineness;
};

Answer timed_solve(const Puzzle& p, bool all, double& us, double& simulations) {
  const double begin = app::cpu_seconds();
  Answer a = solve(p, {.all = all, .robustness = p.prefer == Prefer::robust, .suggest = false});
  us += 1e6 * (app::cpu_seconds() - begin);
  simulations += static_cast<double>(a.simulations);
  return a;
}

/// Returns the first shot, if it is at the centre; shots beside the centre are not compared.
std::optional<Contender> contender(const Answer& a) {
  if (a.shots.empty() || a.shots.front().verification.off_centre) return {};
  const Shot& s = a.shots.front();
  return Contender{s.launch, s.spin, s.path.arrival.time};
}

bool says_so(const std::string& message) {
  for (const char* words : {"better", "not compared", "not all routes"})
    if (message.find(words) != std::string::npos) return true;
  return false;
}

void draw_chances(const Puzzle& p, std::initializer_list<std::optional<Contender>*> contenders) {
  constexpr int draws = 20000;
  constexpr std::uint64_t seed = 20000;
  const test::Aimed aimed(p);
  for (auto* r : contenders)
    if (*r) (*r)->chance = test::drawn_chance(aimed, (*r)->launch, (*r)->spin, draws, seed);
}

std::string told(const std::optional<Contender>& r) {
  if (!r) return "none";
  return fmt::format("{:.6g} m/s at {:.6f} degrees, spin {:.3g} {:.3g} {:.3g}, {:.6g} s, chance {:.4f}",
                     r->launch.speed, degrees(r->launch.angle), r->spin.top, r->spin.side, r->spin.masse, r->time,
                     r->chance);
}

void compare(const Way& way, const Puzzle& p, const Answer& best, std::optional<Contender> first,
             std::optional<Contender> among, std::optional<Contender> forced, Tally& t) {
  std::optional<Contender> climbed;
  if (way.force && among && way.free != "nothing")
    if (const auto r = test::climb_from(p, way.fineness, among->launch, among->spin))
      climbed = Contender{r->launch, r->spin, r->time};
  if (p.prefer == Prefer::robust) draw_chances(p, {&first, &among, &forced, &climbed});
  std::vector<std::string> what;
  double amount = 0;
  const auto note = [&](Count& count, const std::optional<Contender>& a, const std::optional<Contender>& b,
                        const char* words) {
    if (!a || !b) return false;
    const double by = worse(p.prefer, *a, *b);
    if (!count.add(by)) return false;
    amount = std::max(amount, by);
    what.push_back(fmt::format("{} by {:.4g}", words, by));
    return true;
  };
  if (note(t.solve, first, among, "solve below --all")) t.silent += !says_so(best.message);
  if (way.force) {
    note(t.solve_below_force, first, forced, "solve below force");
    note(t.all_below_force, among, forced, "--all below force");
    note(t.force, forced, among, "force below --all");
    note(t.climbs, among, climbed, "--all below what it climbs to");
    t.no_force += !forced;
  }
  if (best.shots.empty() || (forced && (!first || !among))) {
    what.push_back(fmt::format("solve: {}", best.message));
    amount = 1;
  }
  if (what.empty()) return;
  t.cases.emplace_back(
      amount, fmt::format("{}\n  solve {}\n  all   {}\n  force {}\n  climb {}\n{}", fmt::join(what, ", "), told(first),
                          told(among), told(forced), told(climbed), write_puzzle(p)));
}

void one(const Way& way, test::Random& random, Tally& t) {
  const Puzzle p = random_case(random, way.model, way.free, way.prefer).puzzle;
  ++t.puzzles;
  const Answer best = timed_solve(p, false, t.us_solve, t.simulations_solve),
               all = timed_solve(p, true, t.us_all, t.simulations_all);
  t.unsolved_solve += best.shots.empty();
  t.unsolved_all += all.shots.empty();
  const auto first = contender(best), among = contender(all);
  std::optional<Contender> forced;
  if (way.force) {
    const double begin = app::cpu_seconds();
    const test::ByForce f = test::best_by_force(p, way.fineness);
    t.us_force += 1e6 * (app::cpu_seconds() - begin);
    t.simulations_force += static_cast<double>(f.simulations);
    if (f.best) forced = Contender{f.best->launch, f.best->spin, f.best->time};
    t.beside_solve += !first && !best.shots.empty() && forced;
    t.beside_all += !among && !all.shots.empty() && forced;
  }
  const bool same = first && among && !forced && worse(Prefer::quick, *first, *among) == 0 &&
                    first->launch.speed == among->launch.speed;
  if (!same) compare(way, p, best, first, among, forced, t);
}

constexpr const char* header =
    "physics,free,prefer,seed,aim_step_degrees,puzzles,unsolved_solve,unsolved_all,beside_solve,beside_all,solve_worse,"
    "solve_far_worse,silent,solve_below_force,solve_far_below_force,all_below_force,all_far_below_force,no_force,"
    "force_worse,force_far_worse,all_climbs,all_climbs_far,simulations_solve,us_solve,simulations_all,us_all,"
    "simulations_force,us_force\n";

void print(const Way& way, const std::string& physics, std::uint64_t seed, const Tally& t) {
  const double n = static_cast<double>(t.puzzles);
  std::cout << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},", physics, way.free,
                           prefers[static_cast<int>(way.prefer)], seed, way.force ? degrees(way.fineness.grid.aim) : 0,
                           t.puzzles, t.unsolved_solve, t.unsolved_all, t.beside_solve, t.beside_all, t.solve.worse,
                           t.solve.far, t.silent)
            << fmt::format("{},{},{},{},{},{},{},{},{},", t.solve_below_force.worse, t.solve_below_force.far,
                           t.all_below_force.worse, t.all_below_force.far, t.no_force, t.force.worse, t.force.far,
                           t.climbs.worse, t.climbs.far)
            << fmt::format("{:.1f},{:.1f},{:.0f},{:.0f},{:.0f},{:.0f}\n", t.simulations_solve / n, t.us_solve / n,
                           t.simulations_all / n, t.us_all / n, t.simulations_force / n, t.us_force / n)
            << std::flush;
}

void print_worst(Tally& t, std::size_t most) {
  std::stable_sort(t.cases.begin(), t.cases.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 0; i < std::min(most, t.cases.size()); ++i) std::cerr << t.cases[i].second << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random puzzles: is what solve returns the best shot there is?");
  long count = 100;
  std::uint64_t seed = 1;
  std::size_t worst = 5;
  std::string physics = "spin", free = "all", prefer = "all";
  bool no_force = false, no_header = false;
  double aim_step = 0.02;
  test::Fineness fineness;
  const auto one_of = [](auto names) {
    std::vector<std::string> out(std::begin(names), std::end(names));
    out.push_back("all");
    return CLI::IsMember(out);
  };
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--physics", physics)->check(CLI::IsMember({"rolling", "spin"}))->capture_default_str();
  app.add_option("--free", free)->check(one_of(std::span(frees)))->capture_default_str();
  app.add_option("--prefer", prefer)->check(one_of(std::span(prefers)))->capture_default_str();
  app.add_option("--aim-step", aim_step, "Of the brute force, degrees")->capture_default_str();
  app.add_option("--spins", fineness.spins, "Restarts of the brute force in spins")->capture_default_str();
  app.add_option("--arrivals", fineness.arrivals, "Values of a range of arrival speeds")->capture_default_str();
  app.add_flag("--no-force", no_force, "Only solve against solve --all");
  app.add_flag("--no-header", no_header);
  app.add_option("--worst", worst, "How many of the worst cases to print")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  fineness.grid.aim = radians(aim_step);
  if (!no_header) std::cout << header;
  for (const char* f : frees)
    for (int k = 0; k < 3; ++k) {
      if ((free != "all" && free != f) || (prefer != "all" && prefer != prefers[k])) continue;
      const bool spins = free == "spin" || free == "both";
      if (spins && physics == "rolling") continue;
      const Way way{physics == "spin" ? test::Model::spin : test::Model::rolling, f, static_cast<Prefer>(k), !no_force,
                    fineness};
      Tally t;
      for (long i = 0; i < count; ++i) {
        test::Random random(seed, static_cast<std::uint64_t>(i));
        one(way, random, t);
      }
      print(way, physics, seed, t);
      print_worst(t, worst);
    }
  return 0;
}
