// SPDX-License-Identifier: MIT
#include "app/report/circles.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::app::report {
namespace {

constexpr int most_cushions = 2, draws = 400;

/// Draws a puzzle as people ask it: a pocket, and up to two cushions.
Puzzle draw_puzzle(const TablePreset& preset, Random& random) {
  const Scene scene = preset_scene(preset.name);
  const double R = scene.ball.body.radius;
  Puzzle p{.table = make_table(preset, false), .physics = scene.physics, .ball = scene.ball};
  p.ball.at = {random.uniform(R, preset.length - R), random.uniform(R, preset.width - R)};
  p.target = PocketTarget{random.integer(0, 5)};
  p.cushions = CushionRule::exactly(random.integer(0, most_cushions));
  return p;
}

bool is_made(const Puzzle& p, const Launch& launch, const LaunchSpin& spin) {
  ShotRequest shot{.table = p.table, .physics = p.physics, .ball = p.ball, .launch = launch, .spin = spin};
  shot.until.cushions = p.cushions.max + 1;
  const Trajectory t = bankshot::simulate(shot);
  return t.end == EventKind::pocket && t.cushions >= p.cushions.min && t.cushions <= p.cushions.max &&
         t.events[t.events.size() - 2].contact.index == std::get<PocketTarget>(p.target).pocket;
}

/// Returns the share of a player's launches that are made; aims and speeds have normal errors (Box and Muller 1958).
double chance_of(const Puzzle& p, const Shot& shot, Random& random) {
  int made = 0;
  for (int i = 0; i < draws; ++i) {
    const double r = std::sqrt(-2 * std::log(1 - random.uniform(0, 1))), a = random.uniform(0, radians(360));
    const Launch l{shot.launch.speed + p.noise.speed * r * std::cos(a),
                   shot.launch.angle + p.noise.angle * r * std::sin(a)};
    made += l.speed > 0 && is_made(p, l, shot.spin);
  }
  return made / static_cast<double>(draws);
}

}  // namespace

CirclesForJaws circles_for_jaws(int puzzles, Progress& progress) {
  CirclesForJaws out;
  Curve shots{"a shot chosen on circles", {}, Curve::Style::points};
  std::vector<double> told, with_jaws, best;
  int none = 0;
  for (int i = 0; i < puzzles; ++i) {
    for (int k = circle_steps * i / puzzles; k < circle_steps * (i + 1) / puzzles; ++k) progress.step();
    Random random(15, static_cast<std::uint64_t>(i));
    constexpr const char* tables[] = {"pool-7ft", "pool-9ft", "snooker-12ft"};
    const TablePreset& preset = *find_table_preset(tables[random.integer(0, 2)]);
    Puzzle p = draw_puzzle(preset, random);
    const Answer on_circles = bankshot::solve(p, {.suggest = false});
    if (on_circles.shots.empty()) continue;
    p.table = make_table(preset, true);
    const Answer between_jaws = bankshot::solve(p, {.suggest = false});
    const Shot& shot = on_circles.shots.front();
    told.push_back(shot.robustness.success.value_or(0));
    with_jaws.push_back(chance_of(p, shot, random));
    if (between_jaws.shots.empty())
      ++none;
    else
      best.push_back(between_jaws.shots.front().robustness.success.value_or(0));
    shots.points.push_back({told.back(), with_jaws.back(), with_jaws.back(), with_jaws.back()});
    out.csv += fmt::format("{},{:.4f},{:.4f},{}\n", i, told.back(), with_jaws.back(),
                           between_jaws.shots.empty() ? "" : fmt::format("{:.4f}", best.back()));
  }
  out.csv = "puzzle,chance_on_circles,chance_with_jaws,best_with_jaws\n" + out.csv;
  const auto mean = [](const std::vector<double>& all) {
    double sum = 0;
    for (const double x : all) sum += x;
    return all.empty() ? 0 : 100 * sum / static_cast<double>(all.size());
  };
  int off = 0;
  for (std::size_t i = 0; i < told.size(); ++i) off += std::abs(told[i] - with_jaws[i]) > 0.1;
  out.told = fmt::format(
      " On tables with plain circles for pockets {} shots were chosen. Circles give them a mean success of {:.0f} %; "
      "between jaws it is {:.0f} %. For {:.0f} % of these shots the two differ by more than 10 percentage points. The "
      "best shots between jaws have a mean success of {:.0f} %{}.",
      told.size(), mean(told), mean(with_jaws), told.empty() ? 0 : 100.0 * off / static_cast<double>(told.size()),
      mean(best), none > 0 ? fmt::format(", but {} puzzles then have no shot", none) : "");
  out.panel = {"success of a shot into a pocket that is chosen on circles",
               {"as told on circles", false, Range{0, 1}},
               {"between jaws", false, Range{0, 1}},
               {shots, {"as told", {{0, 0, 0, 0}, {1, 1, 1, 1}}, Curve::Style::dashes}}};
  return out;
}

}  // namespace bankshot::app::report
