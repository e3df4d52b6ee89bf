// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "bankshot/plan/planner.hpp"
#include "bankshot/tolerances.hpp"
#include "planners/planners.hpp"
#include "planners/robustness.hpp"
#include "planners/verify.hpp"

namespace bankshot {
namespace {

using planning::Search;

struct Method {
  PlannerInfo info;
  void (*plan)(Search&);
};

constexpr std::array methods{
    Method{{"auto", "images, refined where paths are no straight lines; then sweep; nlopt-direct last"}, planning::automatic},
    Method{{"image", "exact aims by unfolding the table; complete without reflex vertices"}, planning::image},
    Method{{"sweep", "maps every aim (with spin: every aim and speed) and bisects; finds all sequences"}, planning::sweep},
    Method{{"ceres", "Levenberg-Marquardt with dual numbers along a locked cushion sequence"}, planning::ceres},
    Method{{"nlopt-bobyqa", "local search without derivatives from the images (NLopt BOBYQA)"}, planning::nlopt_bobyqa},
    Method{{"nlopt-sbplx", "the same by subspaces of simplices (NLopt SBPLX)"}, planning::nlopt_sbplx},
    Method{{"nlopt-slsqp", "from the images along a locked sequence, dual-number gradient (NLopt SLSQP)"}, planning::nlopt_slsqp},
    Method{{"nlopt-direct", "global search over aim and speed (NLopt DIRECT-L)"}, planning::nlopt_direct},
    Method{{"nlopt-crs", "the same by controlled random search (NLopt CRS2)"}, planning::nlopt_crs},
    Method{{"nlopt-mlsl", "the same by many local searches (NLopt MLSL with BOBYQA)"}, planning::nlopt_mlsl},
};

const Method& find_method(const std::string& name) {
  const auto it = std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.info.name == name; });
  if (it != methods.end()) return *it;
  std::string known;
  for (const Method& m : methods) known += fmt::format("{}{}", known.empty() ? "" : ", ", m.info.name);
  throw InvalidInput("", fmt::format("\"{}\" is no planner; known are {}", name, known));
}

std::vector<std::string> modelled(const Puzzle& p) {
  std::vector<std::string> out{is_ideal(p.physics) ? "ideal" : "rolling"};
  if (!is_straight(p.physics)) out.insert(out.begin(), "sliding");
  constexpr const char* cushions[] = {"mirror", "han2005", "mathavan2010"};
  out.push_back(cushions[p.physics.cushion.index()]);
  if (!p.table.pockets.empty()) out.push_back("pockets");
  return out;
}

/// Larger is better.
double merit(const Puzzle& p, const Shot& shot) {
  switch (p.prefer) {
    case Prefer::soft: return -shot.launch.speed;
    case Prefer::quick: return -shot.arrival.time;
    case Prefer::robust: break;
  }
  return shot.success.value_or(shot.first_order);
}

void rank(const Puzzle& p, std::vector<Shot>& shots) {
  std::stable_sort(shots.begin(), shots.end(), [&](const Shot& a, const Shot& b) {
    const double x = merit(p, a), y = merit(p, b);
    if (x != y) return x > y;
    if (a.first_order != b.first_order) return a.first_order > b.first_order;
    return a.launch.angle < b.launch.angle;
  });
}

/// Where some line reaches the target's centre, shots beside it are no answer.
void keep_centred(const Search& s, std::vector<Shot>& shots) {
  const auto beside = [&](const Shot& shot) { return shot.miss > tolerance::exact_miss * s.boundary.diagonal; };
  if (!std::all_of(shots.begin(), shots.end(), beside)) std::erase_if(shots, beside);
}

/// The reasons that candidates failed for, the most frequent first.
std::string failures(const Search& s) {
  constexpr std::size_t most_named = 3;
  std::vector<Search::Counted> by_count = s.failures;
  std::stable_sort(by_count.begin(), by_count.end(), [](const auto& a, const auto& b) { return a.times > b.times; });
  std::string out;
  for (std::size_t i = 0; i < std::min(most_named, by_count.size()); ++i)
    out += fmt::format("{}it {} ({}×)", i ? "; " : "", explain(s, by_count[i].failure), by_count[i].times);
  if (by_count.size() > most_named) out += fmt::format("; and {} other reason{}", by_count.size() - most_named, by_count.size() > most_named + 1 ? "s" : "");
  return out.empty() ? "no path has the bounces asked" : out;
}

std::string asked_cushions(const CushionRule& c) {
  if (c.sequence) return "the cushions asked, in that order";
  if (c.min == c.max) return fmt::format("exactly {} cushion{}", c.min, c.min == 1 ? "" : "s");
  return fmt::format("{} to {} cushions", c.min, c.max);
}

std::string message(const Search& s, const Answer& a, std::size_t found) {
  std::string text;
  if (a.status == Status::solved) {
    text = found == 1 ? "one shot found" : fmt::format("{} distinct shots found", found);
    if (a.shots.front().miss > tolerance::exact_miss * s.boundary.diagonal) text += "; nothing found reaches the target's centre, this reaches part of it";
    if (s.cut) text += "; the budget ended the search, so there may be better ones";
    if (s.all && !s.complete && !s.cut) text += "; there may be more: shots in a narrow range of aims can be missed";
  } else if (a.status == Status::budget) {
    text = fmt::format("no shot found within the budget of {} simulations", s.puzzle.budget);
  } else if (s.proved) {
    text = fmt::format("proved: every path with {} was tried, and {}", asked_cushions(s.puzzle.cushions), failures(s));
  } else {
    const Range& v = s.puzzle.speed;
    text = fmt::format("searched {} and aims {} with {}: {}",
                       v.fixed() ? fmt::format("the launch speed {:.4g} m/s", v.low) : fmt::format("launch speeds {:.4g} to {:.4g} m/s", v.low, v.high),
                       planning::aims(s), asked_cushions(s.puzzle.cushions), failures(s));
  }
  if (a.status != Status::solved && !s.puzzle.cushions.sequence && s.puzzle.cushions.max > 0 && s.frozen())
    text += "; aims straight into a cushion that the ball touches were left out";
  const PointTarget* point = s.point();
  if (a.status != Status::solved && point && norm(point->at - s.puzzle.ball.at) <= point->within && s.puzzle.cushions.min == 0)
    text += "; the ball starts at its target";
  if (!s.note.empty()) text += "; " + s.note;
  return text;
}

void add_nearest(Search& s, Answer& a) {
  if (a.status == Status::solved || !(s.near.launch.speed > 0)) return;
  Shot shot{.launch = s.near.launch};
  shot.launch.speed = std::clamp(shot.launch.speed, s.puzzle.speed.low, s.puzzle.speed.high);
  const auto r = replay(s, shot.launch, planning::Goal::exactly(s, s.near.bounces), &shot.cushions);
  shot.miss = r.miss;
  shot.arrival = r.arrival;
  shot.planner = "none";
  a.nearest = Answer::Nearest{shot, explain(s, s.near.failure)};
}

/// Shots whose success decides their order: more than this are compared by first-order margin.
constexpr std::size_t most_compared = 64;

void add_robustness(Search& s, std::vector<Shot>& shots, bool all) {
  const std::size_t n = std::min(shots.size(), most_compared);
  const bool by_success = s.puzzle.prefer == Prefer::robust;
  if (shots.size() > n && by_success)
    s.add_note(fmt::format("only the {} with the largest first-order margin were compared by success", n));
  for (std::size_t i = 0; i < (by_success || all ? n : 1); ++i) find_success(s, shots[i]);
  if (by_success) {
    std::vector<Shot> head(std::make_move_iterator(shots.begin()), std::make_move_iterator(shots.begin() + static_cast<long>(n)));
    rank(s.puzzle, head);
    std::move(head.begin(), head.end(), shots.begin());
  }
  for (std::size_t i = 0; i < (all ? shots.size() : 1); ++i) {
    if (!shots[i].success) find_success(s, shots[i]);
    find_margin(s, shots[i]);
  }
}

}  // namespace

Answer solve(const Puzzle& puzzle, const SolveOptions& options) {
  validate(puzzle);
  const Method& method = find_method(options.planner);
  const auto begin = std::chrono::steady_clock::now();
  Search s(puzzle, options.all);
  if (!s.spent()) method.plan(s);
  keep_centred(s, s.shots);
  rank(puzzle, s.shots);
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;

  Answer a{.id = puzzle.id};
  a.simulations = s.simulations;
  a.time_us = took.count();
  a.status = !s.shots.empty() ? Status::solved : s.cut ? Status::budget : Status::no_shot;
  a.modelled = modelled(puzzle);
  const std::size_t found = s.shots.size();
  add_nearest(s, a);
  if (options.robustness && found > 0) add_robustness(s, s.shots, options.all);
  if (!options.all && found > 1) s.shots.resize(1);
  a.shots = std::move(s.shots);
  a.message = message(s, a, found);
  return a;
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
