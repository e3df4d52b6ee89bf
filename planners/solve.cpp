// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>

#include "bankshot/plan/planner.hpp"
#include "planners/merit/rank.hpp"
#include "planners/message.hpp"
#include "planners/methods/methods.hpp"

namespace bankshot {
namespace {

using planning::Search;

struct Method {
  PlannerInfo info;
  void (*plan)(Search&);
};

constexpr std::array all_methods{
    Method{{"auto", BANKSHOT_NLOPT ? "images, refined where paths are no straight lines; then sweep; nlopt-direct last"
                                   : "images, refined where paths are no straight lines; then sweep"},
           planning::automatic},
    Method{{"image", "exact aims by unfolding the table; complete without reflex vertices"}, planning::image},
    Method{{"sweep", "maps every aim (with spin: every aim and speed) and bisects; finds all sequences"},
           planning::sweep},
    Method{{"ceres", "Levenberg-Marquardt with dual numbers along a locked cushion sequence"}, planning::ceres},
    Method{{"nlopt-bobyqa", "local search without derivatives from the images (NLopt BOBYQA)"}, planning::nlopt_bobyqa},
    Method{{"nlopt-sbplx", "the same by subspaces of simplices (NLopt SBPLX)"}, planning::nlopt_sbplx},
    Method{{"nlopt-slsqp", "from the images along a locked sequence, dual-number gradient (NLopt SLSQP)"},
           planning::nlopt_slsqp},
    Method{{"nlopt-direct", "global search over aim and speed (NLopt DIRECT-L)"}, planning::nlopt_direct},
    Method{{"nlopt-crs", "the same by controlled random search (NLopt CRS2)"}, planning::nlopt_crs},
    Method{{"nlopt-mlsl", "the same by many local searches (NLopt MLSL with BOBYQA)"}, planning::nlopt_mlsl},
};
/// Without NLopt the six of it are not there.
constexpr std::span<const Method> methods(all_methods.data(), all_methods.size() - (BANKSHOT_NLOPT ? 0 : 6));

const Method& find_method(const std::string& name) {
  const auto it = std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.info.name == name; });
  if (it != methods.end()) return *it;
  std::string known;
  for (const Method& m : methods) known += fmt::format("{}{}", known.empty() ? "" : ", ", m.info.name);
  throw InvalidInput("", fmt::format("\"{}\" is no planner; known are {}", name, known));
}

std::vector<std::string> modelled(const Puzzle& p, const std::vector<Shot>& shots) {
  std::vector<std::string> out{is_ideal(p.physics) ? "ideal" : "rolling"};
  if (!is_straight(p.physics)) out.insert(out.begin(), "sliding");
  constexpr const char* cushions[] = {"mirror", "han2005", "mathavan2010", "custom cushion"};
  out.push_back(cushions[p.physics.cushion.index()]);
  if (std::any_of(shots.begin(), shots.end(), [](const Shot& s) { return s.cushion_stick; }))
    out.push_back("cushion-stick");
  if (!p.table.pockets.empty()) out.push_back("pockets");
  return out;
}

/// One spin, or those of the puzzle's ranges on a grid, least first.
std::vector<LaunchSpin> spins_to_try(const Puzzle& p) {
  if (!p.spin_range) return {p.spin};
  constexpr int steps = 4;
  const auto values = [](const Range& r) {
    std::vector<double> out{std::clamp(0.0, r.low, r.high)};
    for (int i = 0; i <= steps && !r.fixed(); ++i) {
      const double v = r.low + (r.high - r.low) * i / steps;
      if (v != out.front()) out.push_back(v);
    }
    return out;
  };
  std::vector<LaunchSpin> spins;
  for (const double top : values(p.spin_range->top))
    for (const double side : values(p.spin_range->side))
      for (const double masse : values(p.spin_range->masse)) spins.push_back({top, side, masse});
  const auto size = [](const LaunchSpin& s) { return s.top * s.top + s.side * s.side + s.masse * s.masse; };
  std::stable_sort(spins.begin(), spins.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
  return spins;
}

double microseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// Margins, order and words of what a search found.
Answer finish(Search& s, const SolveOptions& options, double time_us) {
  Answer a{.id = s.puzzle.id};
  a.simulations = s.simulations;
  a.time_us = time_us;
  a.cost.certify_us = s.certify_us;
  a.status = !s.shots.empty() ? Status::solved : s.cut ? Status::budget : Status::no_shot;
  const std::size_t found = s.shots.size();
  add_nearest(s, a);
  if (options.robustness && found > 0) {
    const auto begin = std::chrono::steady_clock::now();
    add_robustness(s, s.shots, options.all);
    if (options.measure) a.cost.robustness_us = microseconds_since(begin);
  }
  if (!options.all && found > 1) s.shots.resize(1);
  a.shots = std::move(s.shots);
  a.modelled = modelled(s.puzzle, a.shots);
  a.message = message(s, a, found);
  return a;
}

}  // namespace

Answer solve(const Puzzle& puzzle, const SolveOptions& options) {
  validate(puzzle);
  if (options.all && options.first) throw InvalidInput("", "either all shots are asked for or the first one found");
  const Method& method = find_method(options.planner);
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<LaunchSpin> spins = spins_to_try(puzzle);
  std::optional<Puzzle> one;  // with a spin of its own
  long spent = 0;
  double certify_us = 0;
  for (std::size_t i = 0;; ++i) {
    if (puzzle.spin_range) {
      one = puzzle;
      one->spin = spins[i];
      one->budget =
          spent + (puzzle.budget - spent) / static_cast<long>(spins.size() - i);  // an even share of what is left
    }
    Search s(one ? *one : puzzle, options.all, options.first);
    s.simulations = spent;
    s.measure = options.measure;
    s.certify_us = certify_us;
    if (!s.spent()) method.plan(s);
    spent = s.simulations;
    certify_us = s.certify_us;
    if (s.shots.empty() && spent < puzzle.budget && i + 1 < spins.size()) continue;
    planning::rank(s, s.shots);
    if (puzzle.aim == Aim::safest && !s.shots.empty()) planning::make_safest(s, s.shots.front());
    const double took = microseconds_since(begin);
    if (spins.size() > 1) s.add_note(fmt::format("{} of {} spins were tried, the least first", i + 1, spins.size()));
    Answer a = finish(s, options, took);
    if (a.status != Status::no_shot || !options.suggest) return a;
    const std::string hint = planning::what_would_open(puzzle);
    if (!hint.empty()) a.message += "; " + hint;
    return a;
  }
}

std::span<const PlannerInfo> planners() {
  static const auto infos = [] {
    std::array<PlannerInfo, methods.size()> out{};
    std::transform(methods.begin(), methods.end(), out.begin(), [](const Method& m) { return m.info; });
    return out;
  }();
  return infos;
}

}  // namespace bankshot
