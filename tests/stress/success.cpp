// SPDX-License-Identifier: MIT
//
// Compares the success that an answer says with plain random plays of the same shot.
//   success [--count 200] [--seed 1] [--plays 20000] [--only pots] [--csv FILE]
// Random puzzles of one ball in three physics, layouts in which ball 1 goes into any pocket between jaws, and families
// of shots with other balls. Plays are judged as success is defined. With 20,000 plays a share has a standard error of
// 0.0035 at most.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

#include "bankshot/plan/planner.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/search_result.hpp"
#include "planners/verify/replay.hpp"
#include "support/families.hpp"
#include "support/random_layout.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;
using namespace bankshot::planning;

struct Kind {
  std::string name;
  std::function<Puzzle(Random&)> draw;
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> out;
  constexpr std::pair<const char*, Model> models[] = {
      {"ideal", Model::ideal}, {"rolling", Model::rolling}, {"spin", Model::spin}};
  for (const auto& [name, model] : models)
    out.push_back({fmt::format("one ball, {}", name),
                   [model = model](Random& r) { return random_puzzle(r, Family::uniform, model).puzzle; }});
  for (const int balls : {1, 3, 6})
    out.push_back({fmt::format("layouts of {}", balls), [balls](Random& r) {
                     Puzzle p = random_layout(r, balls);
                     p.target = ObjectBallTarget{{1}, {.target = PocketTarget{}}};
                     p.cushions = CushionRule::exactly(0);
                     return p;
                   }});
  for (const char* name : {"pots", "banks", "kick-pots", "combinations", "caroms", "sent-to-rest", "sent-past"})
    out.push_back({name, [family = find_family(name)](Random& r) { return family->make(r, Model::spin, -1).puzzle; }});
  return out;
}

/// The share of plays that are made.
double by_plays(const SearchRequest& request, const Shot& shot, std::mt19937_64& random, int plays) {
  const Noise& noise = request.puzzle().noise;
  const Goal goal = Goal::counted(request, shot);
  EvaluationBudget budget(plays + 1L);
  std::normal_distribution<double> normal;
  int made = 0;
  for (int i = 0; i < plays; ++i) {
    const double speed = shot.launch.speed + noise.speed_at(shot.launch.speed) * normal(random);
    const double angle = shot.launch.angle + noise.angle * normal(random);
    made += speed > 0 && replay(request, budget, {speed, wrap_angle(angle)}, goal).made;
  }
  return static_cast<double>(made) / plays;
}

struct Row {
  int shots = 0;
  long simulations = 0;
  double sum = 0, squares = 0, worst = 0;

  void add(const Puzzle& p, Shot shot, std::mt19937_64& random, int plays) {
    as_struck(SearchRequest(p), shot, [&](const SearchRequest& request) {
      EvaluationBudget budget(1000);
      find_success(request, budget, shot);
      simulations += budget.simulations();
      const double off = *shot.robustness.success - by_plays(request, shot, random, plays);
      sum += off, squares += off * off, worst = std::max(worst, std::abs(off)), ++shots;
    });
  }
  std::string csv(const std::string& name) const {
    const double n = std::max(shots, 1);
    return fmt::format("{},{},{:.4f},{:.4f},{:.4f},{:.0f}\n", name, shots, sum / n, std::sqrt(squares / n), worst,
                       static_cast<double>(simulations) / n);
  }
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares success with plain plays.");
  int count = 200, plays = 20000;
  std::uint64_t seed = 1;
  std::string only, csv;
  app.add_option("--count", count, "Puzzles of each kind");
  app.add_option("--seed", seed, "Seed of puzzles and plays");
  app.add_option("--plays", plays, "Random plays of each shot");
  app.add_option("--only", only, "Kinds with this in their name");
  app.add_option("--csv", csv, "A file for the table");
  CLI11_PARSE(app, argc, argv);
  std::string table = "kind,shots,mean_off,rms_off,worst_off,simulations\n";
  std::cout << table;
  for (const Kind& kind : all_kinds()) {
    if (kind.name.find(only) == std::string::npos) continue;
    Random random(seed);
    std::mt19937_64 errors(seed);
    Row row;
    for (int i = 0; i < count; ++i) {
      const Puzzle p = kind.draw(random);
      const Answer a = solve(p, {.robustness = false});
      if (!a.shots.empty()) row.add(p, a.shots.front(), errors, plays);
    }
    std::cout << row.csv('"' + kind.name + '"') << std::flush;
    table += row.csv('"' + kind.name + '"');
  }
  std::ofstream(csv) << table;
}
