// SPDX-License-Identifier: MIT
//
// Section 3: how near each planner comes, for how many simulations and how much time.
#include <fmt/format.h>

#include <cmath>

#include "app/report/derivatives.hpp"
#include "app/report/sections.hpp"
#include "app/report/suite.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"

namespace bankshot::app::report {
namespace {

constexpr double floor_of_figure = 1e-17;  // m: a miss of 0 is drawn here

struct Kind {
  std::string name;
  Physics physics;
  int share;      ///< only one in so many puzzles is used, if this physics is slow
  double budget;  ///< most simulations
};

std::vector<Kind> kinds(const Settings& settings) {
  Physics fullest = spin_physics();
  fullest.cushion = FullestCushion{};
  const double most = settings.shots < 3 ? 100 : settings.quick ? 3e3 : 3e4;
  return {{"ideal", ideal_physics(), 1, most},
          {"rolling", rolling_physics(), 1, most},
          {spin_with(usual_cushion), spin_physics(), 1, most},
          {spin_with(fullest_cushion), fullest, 3, most / 10}};
}

std::vector<long> budgets(double most) {
  std::vector<long> out;
  for (double b = 10; b <= most * 1.01; b *= std::sqrt(10.0)) out.push_back(std::lround(b));
  return out;
}

/// The result of one planner on one puzzle with one budget.
struct Outcome {
  double miss, simulations, seconds;
  bool solved, cut;  ///< solved: exactly; cut: the budget ended the search
};

Outcome attempt(Puzzle p, const std::string& planner, long budget) {
  p.budget = budget;
  Answer a;
  constexpr double short_time_ = 1e-3;
  double least = forever;
  for (int i = 0; i < 3 && (i == 0 || least < short_time_); ++i) {
    const double begin = cpu_seconds();
    a = bankshot::solve(p, {.planner = planner, .robustness = false, .suggest = false});
    least = std::min(least, cpu_seconds() - begin);
  }
  const double diagonal = p.table.diagonal();
  double miss =
      // If there is nothing at all, the miss is the whole table.
      a.nearest ? std::min(a.nearest->shot.verification.miss, diagonal) : diagonal;
  for (const Shot& s : a.shots) miss = std::min(miss, s.verification.miss);
  return {miss, static_cast<double>(a.simulations), least, miss <= tolerance::exact_miss * diagonal,
          a.status == Status::budget};
}

/// All outcomes of a planner on a set with one budget.
struct Setting {
  long budget = 0;
  Spread miss, simulations, seconds;
  double solved = 0;  ///< percent
};

Setting summed(long budget, const std::vector<Outcome>& all) {
  std::vector<double> miss, simulations, seconds;
  double solved = 0;
  for (const Outcome& o : all) {
    miss.push_back(std::max(o.miss, floor_of_figure));
    simulations.push_back(std::max(o.simulations, 1.0));
    seconds.push_back(o.seconds);
    solved += o.solved;
  }
  return {budget, spread(miss), spread(simulations), spread(seconds), 100 * solved / static_cast<double>(all.size())};
}

struct Curves {
  std::string planner;
  std::vector<Setting> settings;            ///< over all levels
  std::array<Setting, levels.size()> last;  ///< for each level, with the largest budget
};

/// Raw numbers and their medians, as CSV.
struct Tables {
  std::string puzzles = "physics,planner,level,puzzle,budget,miss_m,simulations,seconds,solved\n";
  std::string settings =
      "physics,planner,level,puzzles,budget,solved_percent,miss_median,miss_high_90,simulations_median,simulations_"
      "high_90,seconds_median,"
      "seconds_high_90\n";

  void add(const Kind& kind, const std::string& planner, const char* level, std::size_t count, const Setting& s) {
    settings += fmt::format("\"{}\",{},{},{},{},{:.1f},{:.3g},{:.3g},{:.0f},{:.0f},{:.3g},{:.3g}\n", kind.name, planner,
                            level, count, s.budget, s.solved, s.miss.median, s.miss.high, s.simulations.median,
                            s.simulations.high, s.seconds.median, s.seconds.high);
  }
};

Curves measure(const Kind& kind, const std::string& planner, const std::array<std::vector<Puzzle>, levels.size()>& sets,
               Tables& csv) {
  Curves c{planner, {}, {}};
  std::array<std::vector<Outcome>, levels.size()> before;
  for (const long budget : budgets(kind.budget)) {
    std::vector<Outcome> all;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      std::vector<Outcome> now;
      for (std::size_t i = 0; i < sets[l].size(); ++i) {
        // A search that ended by itself gives the same result with a larger budget.
        now.push_back(!before[l].empty() && !before[l][i].cut ? before[l][i] : attempt(sets[l][i], planner, budget));
        const Outcome& o = now.back();
        csv.puzzles += fmt::format("\"{}\",{},{},{},{},{:.4g},{:.0f},{:.4g},{}\n", kind.name, planner, name(levels[l]),
                                   i, budget, o.miss, o.simulations, o.seconds, o.solved ? 1 : 0);
      }
      all.insert(all.end(), now.begin(), now.end());
      c.last[l] = summed(budget, now);
      csv.add(kind, planner, name(levels[l]), now.size(), c.last[l]);
      before[l] = std::move(now);
    }
    c.settings.push_back(summed(budget, all));
    csv.add(kind, planner, "all", all.size(), c.settings.back());
  }
  return c;
}

/// Adds three panels: the miss against time and against simulations, and the share solved.
void add_panels(const std::string& kind, const std::vector<Curves>& all, std::vector<Panel>& panels) {
  Panel time{kind, {"processor time per puzzle [s]", true}, {"miss [m]", true}, {}};
  Panel simulations{kind, {"simulations", true}, {"miss [m]", true}, {}};
  Panel share{kind, {"simulations", true}, {"solved [%]", false, Range{-4, 104}}, {}};
  for (const Curves& c : all) {
    Curve a{c.planner, {}}, b = a, d = a;
    for (const Setting& s : c.settings) {
      a.points.push_back({s.seconds.median, s.miss.median, s.miss.median, s.miss.median});
      b.points.push_back({s.simulations.median, s.miss.median, s.miss.median, s.miss.median});
      d.points.push_back({s.simulations.median, s.solved, s.solved, s.solved});
    }
    time.curves.push_back(a);
    simulations.curves.push_back(b);
    share.curves.push_back(d);
  }
  panels.insert(panels.end(), {time, simulations, share});
}

void add_rows(const std::string& kind, const std::vector<Curves>& all, Numbers& table) {
  for (const Curves& c : all) {
    std::vector<std::string> row{kind, c.planner};
    for (const Setting& s : c.last) row.push_back(fmt::format("{:.0f} %", s.solved));
    const Setting& s = c.settings.back();
    row.insert(row.end(), {short_length(s.miss.median <= floor_of_figure ? 0 : s.miss.median),
                           short_length(s.miss.high), short_count(s.simulations.median),
                           short_count(s.simulations.high), short_time(s.seconds.median), short_time(s.seconds.high)});
    table.rows.push_back(row);
  }
}

constexpr const char* question = "Which planner finds the shots, and what does it cost?";
constexpr const char* about =
    "A fixed suite of puzzles is made from random shots on a 9-foot table. A ball must rest at a point, or pass "
    "through it in ideal. Easy puzzles have 1 or 2 cushions, and medium ones 3. Long ones have 4 or 5. Every "
    "other puzzle gives the sequence of cushions. Every planner gets every budget of simulations. The miss is "
    "that of the best verified shot, or of the nearest miss where there is no shot. Where there is not even that, "
    "the miss is the whole table, so that failures stay in the medians. Solved means a miss of at most 1e-9 of "
    "the diagonal. Curves are medians over all levels, with one point per budget. The last row of the figure "
    "seeks one root along one sequence, from the seed of its image. It compares derivatives by dual numbers, "
    "derivatives by differences, and none.";

}  // namespace

Section planners(const Settings& settings, Progress& progress) {
  const std::vector<Kind> all = kinds(settings);
  progress.begin("planners", all.size() * bankshot::planners().size() + derivatives_steps);
  Section s{.name = "3-planners", .title = "Planners", .question = question, .about = about};
  s.table = {{"physics", "planner", "easy", "medium", "hard", "miss, median", "90 %", "simulations, median", "90 %",
              "time, median", "90 %"},
             {},
             2};
  Tables csv;
  Setting ours, best;
  std::string best_name;
  for (const Kind& kind : all) {
    std::array<std::vector<Puzzle>, levels.size()> sets;
    for (std::size_t l = 0; l < levels.size(); ++l)
      sets[l] = suite(kind.physics, levels[l], std::max(1, settings.shots / kind.share));
    std::vector<Curves> curves;
    for (const PlannerInfo& planner : bankshot::planners()) {
      progress.step();
      if (!planner.bends && !is_straight(kind.physics)) continue;
      curves.push_back(measure(kind, std::string(planner.name), sets, csv));
      const Setting& last = curves.back().settings.back();
      if (kind.name != spin_with(usual_cushion)) continue;
      if (planner.name == "auto")
        ours = last;
      else if (best_name.empty() || last.solved > best.solved ||
               (last.solved == best.solved && last.seconds.median < best.seconds.median))
        best = last, best_name = planner.name;
    }
    add_panels(kind.name, curves, s.figure.panels);
    add_rows(kind.name, curves, s.table);
  }
  for (const PlannerInfo& planner : bankshot::planners()) s.figure.names.emplace_back(planner.name);
  const std::string derivatives = add_derivatives(settings, s, progress);
  s.figure.columns = 3;
  s.caption = fmt::format(
      "{} puzzles per level ({} with {}). Left and middle: the median miss. Right: the share solved, at the "
      "median number of simulations spent.",
      settings.shots, std::max(1, settings.shots / all.back().share), fullest_cushion.key);
  s.conclusion = fmt::format(
      "With spin, auto solves {:.0f} % of the puzzles, in a median of {} and {} simulations. The next best, {}, solves "
      "{:.0f} % in {} and {} simulations. The cost of one root along a known sequence "
      "depends on the derivatives.{}",
      ours.solved, short_time(ours.seconds.median), short_count(ours.simulations.median), best_name, best.solved,
      short_time(best.seconds.median), short_count(best.simulations.median), derivatives);
  s.data.insert(s.data.begin(), {{s.name, csv.settings}, {s.name + "-puzzles", csv.puzzles}});
  return s;
}

}  // namespace bankshot::app::report
