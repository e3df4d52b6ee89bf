// SPDX-License-Identifier: MIT
//
// Every planner on the same random puzzles with spin: a ball must rest at a point after an exact number of cushions, on
// rectangles without pockets. Prints one line of CSV per planner. The method "mirror" only aims at the mirror image, at
// the speed that carries the ball abreast of its target. With `--pocket` the puzzles are those people write: a ball on
// a 9-foot table, a pocket and a number of cushions; only puzzles with a shot are kept.
//   planners --count 300 --seed 4 --cushions 3 [--sequence | --pocket]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "planners/propose/unfold.hpp"
#include "planners/solve/speed.hpp"
#include "planners/verify/replay.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;

struct Outcome {
  bool exact = false, near = false;  // on the root; within a ball's radius
  double simulations = 0, us = 0;
};

std::vector<Puzzle> puzzles(int count, std::uint64_t seed, int cushions, bool sequence) {
  test::Random random(seed);
  std::vector<Puzzle> out;
  while (static_cast<int>(out.size()) < count) {
    const Puzzle p = test::random_puzzle(random, test::Family::uniform, test::Model::spin, cushions).puzzle;
    const bool rests = std::holds_alternative<PointTarget>(p.target) && !p.arrive && !p.speed.fixed();
    if (p.table.pockets.empty() && rests && sequence == p.cushions.sequence.has_value()) out.push_back(p);
  }
  return out;
}

std::vector<Puzzle> into_pockets(int count, std::uint64_t seed, int cushions) {
  test::Random random(seed);
  std::vector<Puzzle> out;
  while (static_cast<int>(out.size()) < count) {
    const Scene scene = preset_scene("pool-9ft");
    Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
    const Vec2d room = p.table.highest();
    p.ball.at = {random.uniform(0.1, room.x - 0.1), random.uniform(0.1, room.y - 0.1)};
    p.target = PocketTarget{random.integer(0, 5)};
    p.cushions = CushionRule::exactly(cushions);
    if (solve(p, {.robustness = false, .suggest = false}).status == Status::solved) out.push_back(p);
  }
  return out;
}

/// Measures one solve; a short one is repeated up to three times and the least time counts.
Outcome by_planner(const Puzzle& p, const SolveOptions& options) {
  constexpr double is_long = 1000;  // us
  Answer a;
  double least = 1e300;
  for (int run = 0; run < 3 && (run == 0 || least < is_long); ++run) {
    const auto begin = std::chrono::steady_clock::now();
    a = solve(p, options);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count());
  }
  const double miss = !a.shots.empty() ? a.shots[0].verification.miss
                      : a.nearest      ? a.nearest->shot.verification.miss
                                       : 1;
  return {!a.shots.empty() && miss <= 1e-9 * p.table.diagonal(), miss <= p.ball.body.radius,
          static_cast<double>(a.simulations), least};
}

/// Returns the best of the mirror's aims, each replayed once.
Outcome by_mirror(const Puzzle& p) {
  using namespace planning;
  const auto begin = std::chrono::steady_clock::now();
  const SearchRequest request(p);
  EvaluationBudget budget(budget_of(p));
  Unfolding images(request, {.parts = true, .restitution = 1, .keep_routes = true});
  double least = 1;
  while (const auto c = images.next()) {
    const Route route = images.route(*c);
    const Branch aim{request, route, request.problem->aim_points[c->aim_point]};
    auto speed = speed_at(aim, budget, c->angle, c->distance);
    if (speed) speed = speed_near(aim, budget, c->angle, *speed);
    if (speed)
      least = std::min(least, replay(request, budget, {*speed, c->angle}, Goal::exactly(request, c->bounces)).miss);
  }
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  return {least <= 1e-9 * p.table.diagonal(), least <= p.ball.body.radius, static_cast<double>(budget.simulations()),
          took.count()};
}

double part(std::vector<double> v, double share) {
  std::sort(v.begin(), v.end());
  return v[std::min(v.size() - 1, static_cast<std::size_t>(share * static_cast<double>(v.size())))];
}

void print(const std::string& name, int cushions, const std::string& given, const std::vector<Outcome>& all) {
  std::vector<double> simulations, us;
  double exact = 0, near = 0;
  for (const Outcome& o : all) {
    simulations.push_back(o.simulations);
    us.push_back(o.us);
    exact += o.exact;
    near += o.near;
  }
  const double n = static_cast<double>(all.size());
  std::cout << fmt::format("{},{},{},{},{:.4f},{:.4f},{:.0f},{:.0f},{:.1f},{:.1f}\n", name, cushions, given, all.size(),
                           exact / n, near / n, part(simulations, 0.5), part(simulations, 0.99), part(us, 0.5),
                           part(us, 0.99));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Every planner on the same puzzles");
  int count = 300, cushions = 3;
  std::uint64_t seed = 4;
  bool sequence = false, pocket = false, centre = false, header = false;
  std::string only;
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--cushions", cushions)->capture_default_str();
  app.add_option("--only", only, "One planner");
  app.add_flag("--sequence", sequence, "The sequence is given, not only the count");
  app.add_flag("--pocket", pocket, "Into a pocket, arriving as prefer likes");
  app.add_flag("--centre", centre, "The shots stay on the exact line");
  app.add_flag("--header", header);
  CLI11_PARSE(app, argc, argv);
  std::vector<Puzzle> set = pocket ? into_pockets(count, seed, cushions) : puzzles(count, seed, cushions, sequence);
  if (centre)
    for (Puzzle& p : set) p.aim = Aim::centre;
  const std::string given = std::string(pocket     ? "pocket"
                                        : sequence ? "sequence"
                                                   : "count") +
                            (centre ? " centre" : "");
  if (header)
    std::cout << "planner,cushions,given,puzzles,exact,within_ball_radius,simulations_median,simulations_p99,us_median,"
                 "us_p99\n";
  const auto run = [&](const std::string& name, auto&& solve_one) {
    if (!only.empty() && only != name) return;
    std::vector<Outcome> all;
    for (const Puzzle& p : set) all.push_back(solve_one(p));
    print(name, cushions, given, all);
  };
  run("mirror", by_mirror);
  for (const PlannerInfo& planner : planners())
    if (planner.bends)
      run(std::string(planner.name), [&](const Puzzle& p) {
        return by_planner(p, {.planner = std::string(planner.name), .robustness = false, .suggest = false});
      });
  const auto bare_and_whole = [&](const std::string& name, SolveOptions options) {
    options.suggest = false;
    run(name + " with margin and success", [&](const Puzzle& p) { return by_planner(p, options); });
    options.robustness = false;
    if (name != "auto") run(name, [&](const Puzzle& p) { return by_planner(p, options); });
  };
  bare_and_whole("auto", {});
  bare_and_whole("auto --first", {.first = true});
  bare_and_whole("auto --all", {.all = true});
}
